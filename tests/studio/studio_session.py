"""What the tests of the studio share: a real window on a display of its own, a real mouse, and what is on screen."""
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import numpy as np
import OpenImageIO as oiio
import Xlib.display
import Xlib.X

HERE = os.path.dirname(os.path.abspath(__file__))
PROGRAM = os.environ.get('SWAPLIGHT') or os.path.join(HERE, '../../build/release/swaplight')
SAMPLES = os.path.join(HERE, '../samples')
ARTEFACTS = os.path.join(os.path.dirname(os.path.abspath(PROGRAM)), 'test-artefacts')
TOOLS = ['Xvfb', 'xdotool']
ECHO_KEY = 202  # X's number of F24, which no action has: the studio counts how often it has seen it
SAME_PLACE = 8  # pixels: two clicks so near to each other may be a double click
NO_DOUBLE_CLICK = 0.6  # seconds, and as long as a frame may take

missing = [tool for tool in TOOLS if not shutil.which(tool)]
if missing:
    print('SKIPPED: these programs are not installed: ' + ', '.join(missing), file=sys.stderr)
    sys.exit(77)


def read_png(path):
    """height x width x 3, 0..255."""
    source = oiio.ImageInput.open(path)
    assert source, oiio.geterror()
    spec = source.spec()
    pixels = np.asarray(source.read_image('uint8')).reshape(spec.height, spec.width, spec.nchannels)
    source.close()
    return pixels[..., :3].astype(np.int32)


def write_png(path, pixels):
    height, width, channels = pixels.shape
    out = oiio.ImageOutput.create(path)
    spec = oiio.ImageSpec(width, height, channels, 'uint8')
    spec.attribute('png:compressionLevel', 1)
    assert out.open(path, spec) and out.write_image(pixels), out.geterror()
    out.close()


def read_float(path):
    """height x width x channels of an EXR, and the channels' names."""
    source = oiio.ImageInput.open(path)
    assert source, oiio.geterror()
    spec = source.spec()
    pixels = np.asarray(source.read_image('float')).reshape(spec.height, spec.width, spec.nchannels)
    source.close()
    return pixels, spec.channelnames


class Display:
    """An X server without a monitor."""

    def __init__(self, width, height):
        read, write = os.pipe()
        # It resets itself when its last program ends, and would throw out the next test's that comes at that moment.
        self.process = subprocess.Popen(
            ['Xvfb', '-displayfd', str(write), '-screen', '0', f'{width}x{height}x24', '-nolisten', 'tcp', '-r', '-noreset'],
            pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as numbers:
            self.name = ':' + numbers.readline().strip()
        self.connection = None

    def pixels(self):
        """All of the screen: height x width x 3, 0..255."""
        if self.connection is None:
            self.connection = Xlib.display.Display(self.name)
        root = self.connection.screen().root
        size = root.get_geometry()
        image = root.get_image(0, 0, size.width, size.height, Xlib.X.ZPixmap, 0xffffffff)
        pixels = np.frombuffer(image.data, np.uint8).reshape(size.height, size.width, 4)
        return np.ascontiguousarray(pixels[..., 2::-1])

    def close(self):
        if self.connection is not None:
            self.connection.close()
        self.process.terminate()
        self.process.wait()


class Studio:
    """The studio in a window. Files of its own in `home`, so that no other run is seen. Unless `plain_view` is False, sets
    open in the configuration's own view, without tone mapping, as if that had been chosen last: tests then know which
    code a light has."""

    def __init__(self, display, home, *arguments, size='1280x720', scale='1', environment=None, plain_view=True):
        self.home = home
        if plain_view:
            self.remember_plain_view()
        self.probe = os.path.join(home, 'layout.json')
        if os.path.exists(self.probe):
            os.remove(self.probe)
        self.display = display
        self.environment = {**os.environ, 'DISPLAY': display.name, 'LC_ALL': 'C.UTF-8', 'HOME': home}
        for name in ('OCIO', 'XDG_CONFIG_HOME', 'XDG_DATA_HOME', 'XDG_STATE_HOME', 'WAYLAND_DISPLAY'):
            self.environment.pop(name, None)
        self.environment.update(environment or {})
        # A machine that draws five frames a second: SWAPLIGHT_FRAME_SECONDS=0.2
        slow = self.environment.get('SWAPLIGHT_FRAME_SECONDS')
        self.process = subprocess.Popen(
            [PROGRAM, 'studio', *map(str, arguments), '--scale', scale, '--probe-layout', self.probe]
            + (['--size', size] if size else []) + (['--frame-seconds', slow] if slow else []),
            env=self.environment, stderr=subprocess.PIPE, text=True)
        # One for all that is done: starting one takes ten times as long as what it does.
        self.hands = subprocess.Popen(['xdotool', '-'], env=self.environment, stdin=subprocess.PIPE, text=True, bufsize=1)
        self.last_click = (-1000, -1000, 0)

    def remember_plain_view(self):
        path = os.path.join(self.home, '.local/state/swaplight/view.json')
        if os.path.exists(path):
            return
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, 'w') as file:
            json.dump({'built-in': {'display': '', 'view': ''}}, file)

    # What is on the screen

    def layout(self):
        try:
            with open(self.probe) as file:
                return json.load(file)
        except (FileNotFoundError, json.JSONDecodeError):
            return {'items': {}}

    def wait(self, condition, what, seconds=60):
        """Waits until condition(layout) holds; returns the layout."""
        end = time.time() + seconds
        while time.time() < end:
            if self.process.poll() is not None:
                raise AssertionError(f'the studio ended with {self.process.returncode}: {self.process.stderr.read()}')
            layout = self.layout()
            if condition(layout):
                return layout
            time.sleep(0.05)
        raise AssertionError(f'not within {seconds} s: {what}; there is {sorted(self.layout()["items"])}')

    def wait_ready(self):
        return self.wait(lambda layout: layout.get('status') == 'ready' and 'viewer.picture' in layout['items'],
                         'the picture')

    def item(self, name):
        layout = self.wait(lambda layout: name in layout['items'], name)
        return layout['items'][name]

    def has(self, name):
        return name in self.layout()['items']

    def state(self, name):
        return self.layout().get(name)

    def screenshot(self, name):
        """The window's pixels; also kept as an artefact of this name."""
        self.settle()
        os.makedirs(ARTEFACTS, exist_ok=True)
        pixels = self.display.pixels()
        write_png(os.path.join(ARTEFACTS, name + '.png'), pixels)
        return pixels.astype(np.int32)

    def picture(self, name):
        """The pixels of the picture in the viewer, without messages over it: those that pass are waited for."""
        x0, y0, x1, y1 = map(int, self.item('viewer.picture'))
        end = time.time() + 20
        while self.is_covered(x0, y0, x1, y1) and time.time() < end:
            time.sleep(0.05)
        return self.screenshot(name)[y0:y1, x0:x1]

    def is_covered(self, x0, y0, x1, y1):
        """Whether a message lies over a part of this rectangle once all that was done so far has been drawn."""
        self.settle()
        return any(left < x1 and x0 < right and top < y1 and y0 < bottom
                   for name, (left, top, right, bottom) in self.layout()['items'].items() if name.startswith('message.'))

    def processor_seconds(self):
        """What the studio has used of all processors since it was started."""
        with open(f'/proc/{self.process.pid}/stat') as file:
            fields = file.read().rpartition(')')[2].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf('SC_CLK_TCK')

    def echoes(self):
        return int(self.layout().get('echoes', 0))

    def rest(self):
        """Waits until all that was done so far has been drawn: the studio answers to a key that does nothing, which waits
        its turn like every other."""
        before = self.echoes()
        self.xdotool('key', ECHO_KEY)
        self.wait_echo(before)

    def wait_echo(self, before):
        end = time.time() + 60
        while self.echoes() <= before and self.process.poll() is None:
            if self.hands.poll() is not None:
                raise AssertionError('xdotool has ended: it did not understand what it was told')
            if time.time() > end:
                raise AssertionError('the studio does not answer to keys')
            time.sleep(0.01)

    def settle(self):
        """Waits until nothing is being worked at in the background either."""
        self.rest()
        self.wait(lambda layout: layout.get('busy') != 'yes', 'all work is done')
        self.rest()
        time.sleep(0.15)

    # A mouse and a keyboard

    def xdotool(self, *words):
        """Does it after all that came before, without waiting for it."""
        print(*map(self.quoted, map(str, words)), file=self.hands.stdin, flush=True)

    @staticmethod
    def quoted(word):
        """As a word of a line that xdotool reads."""
        quote = "'" if '"' in word else '"'
        assert word and quote not in word and '\n' not in word and word[0] != '$', f'xdotool cannot be told {word!r}'
        return quote + word + quote

    def act(self, *words):
        """Does it, and waits until its effect is on the screen."""
        before = self.echoes()
        self.xdotool(*words, 'key', ECHO_KEY)
        self.wait_echo(before)

    def point(self, name, x=0.5, y=0.5):
        return self.inside(self.item(name), x, y)

    @staticmethod
    def inside(rectangle, x, y):
        x0, y0, x1, y1 = rectangle
        return round(x0 + x * (x1 - x0 - 1)), round(y0 + y * (y1 - y0 - 1))

    def move(self, x, y):
        self.act('mousemove', x, y)

    def click(self, name, x=0.5, y=0.5, button=1):
        place = self.point(name, x, y)
        self.move(*place)
        # What has just been opened takes its place in a frame or two; what opens when the mouse comes hides its name.
        while (now := self.layout()['items'].get(name)) and self.inside(now, x, y) != place:
            place = self.inside(now, x, y)
            self.move(*place)
        self.click_at(*place, button=button)

    def click_at(self, x, y, button=1):
        self.no_double_click(x, y)
        self.act('mousemove', x, y, 'mousedown', button, 'mouseup', button)
        self.last_click = (x, y, time.time())

    def no_double_click(self, x, y):
        """Waits where another press would be the second one of a double click."""
        last_x, last_y, last_time = self.last_click
        if max(abs(x - last_x), abs(y - last_y)) <= SAME_PLACE:
            time.sleep(max(0, last_time + NO_DOUBLE_CLICK - time.time()))

    def double_click(self, x, y):
        self.move(x, y)
        self.no_double_click(x, y)  # with the click before it, the first of the two would be the second
        self.act('click', '--repeat', '2', '--delay', '80', '1')
        self.last_click = (x, y, time.time())

    def drag(self, start, end, button=1, steps=8):
        self.move(*start)
        self.no_double_click(*start)
        self.xdotool('mousedown', button)
        for step in range(1, steps + 1):
            self.move(*(round(a + (b - a) * step / steps) for a, b in zip(start, end)))
        self.act('mouseup', button)
        self.last_click = (*start, time.time())

    def key(self, *keys):
        for key in keys:
            self.act('key', key)

    def type(self, text):
        # All at once: the studio takes it in order. What the keyboard lacks is put on a key for a moment, as long as that takes.
        self.xdotool('type', '--delay', '0' if text.isascii() else '15', '--', text)
        self.rest()

    # The end

    def kill(self):
        self.process.send_signal(signal.SIGKILL)
        self.process.communicate()
        self.let_go()

    def let_go(self):
        if not self.hands.stdin.closed:
            self.hands.stdin.close()
        self.hands.wait()

    def quit(self):
        """Ends it as a person does; True where it went without complaint."""
        self.xdotool('key', 'ctrl+q')
        try:
            _, complaint = self.process.communicate(timeout=20)
        except subprocess.TimeoutExpired:
            print(f'the studio did not end; there is {self.layout()}', file=sys.stderr)
            self.kill()
            return False
        self.let_go()
        if self.process.returncode != 0:
            print(f'the studio ended with {self.process.returncode}: {complaint}', file=sys.stderr)
        return self.process.returncode == 0

    def resize(self, width, height):
        """By an xdotool of its own: one that has chosen a window ends with an error when the window is gone before a key
        is let go, as after Ctrl+Q. The keyboard then holds it for good, and the next studio never sees it pressed."""
        subprocess.run(['xdotool', 'search', '--name', 'Swaplight', 'windowsize', '%@', str(width), str(height)],
                       env=self.environment, check=True)
        self.settle()


class StudioTest(unittest.TestCase):
    """One display a class, one folder a test."""
    size = (1280, 720)

    @classmethod
    def setUpClass(cls):
        cls.display = Display(*cls.size)
        cls.addClassCleanup(cls.display.close)  # also where a class that is set up further fails there

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix='swaplight-studio-')
        self.studio = None

    def tearDown(self):
        if self.studio:
            if self.studio.process.poll() is None:
                self.studio.kill()
            self.studio.let_go()
        shutil.rmtree(self.folder, ignore_errors=True)

    def path(self, name):
        return os.path.join(self.folder, name)

    def show(self, name, within=None):
        """Chooses what is looked at, by the list above the picture; `within`: the list of that list."""
        self.studio.click('bar.subject')
        if within:
            self.studio.click('subject.' + within)
        self.studio.click('subject.' + name)
        self.studio.move(640, 705)

    def export_frame(self, name):
        """Exports what is seen; its file."""
        frame = self.path(name)
        self.studio.key('ctrl+e')
        self.studio.item('export.file')
        self.studio.key('ctrl+a')
        self.studio.type(frame)
        self.studio.key('Return')
        self.studio.wait(lambda layout: os.path.exists(frame), 'the frame')
        self.studio.settle()
        return frame

    def save_as(self, name):
        """Saves the session by the dialog; gives the file and what is in it."""
        path = self.path(name + '.swaplight')
        self.studio.key('ctrl+shift+s')
        self.studio.item('chooser.name')
        self.studio.key('ctrl+a')
        self.studio.type(path)
        self.studio.key('Return')
        self.studio.wait(lambda layout: layout.get('title', '').startswith(name), 'the session has a name')
        with open(path) as file:
            return path, json.load(file)

    def start(self, *arguments, **options):
        self.studio = Studio(self.display, self.folder, *arguments, size='%dx%d' % self.size, **options)
        return self.studio

    def open_sample(self, name='three_point', **options):
        studio = self.start(os.path.join(SAMPLES, name), **options)
        studio.wait_ready()
        return studio

    def open_edits(self, light='key', name='three_point'):
        """A sample with the list of edits, for a light."""
        studio = self.open_sample(name)
        studio.click(f'mixer.{light}.chip')
        studio.move(*studio.point('viewer.picture', 0.5, 0.02))
        studio.key('F4')
        studio.item('edits.add')
        return studio

    def add(self, kind):
        """Adds an edit of this kind to the list."""
        self.studio.click('edits.add')
        self.studio.item('add.' + kind)
        self.studio.settle()
        self.studio.click('add.' + kind)
        self.studio.settle()
