"""A studio that works through a script and is killed at some moment; what it has left behind."""
import glob
import json
import os
import shutil
import signal
import subprocess
import tempfile
import threading
import time

HERE = os.path.dirname(os.path.abspath(__file__))
PROGRAM = os.environ.get('SWAPLIGHT') or os.path.join(HERE, '../../build/release/swaplight')
SAMPLE = os.path.abspath(os.path.join(HERE, '../samples/two_swapped/capture.json'))
STEPS = 400
STEP_SECONDS = 0.04


def script(light, saved):
    """Step n sets the light to n hundredths of a stop; now and then the session is saved, too."""
    lines = [f'open {SAMPLE}', 'wait']
    for step in range(1, STEPS + 1):
        lines += [f'light {light} +{step / 100:.2f}st', f'say {step}', f'sleep {STEP_SECONDS}']
        if step % 60 == 0:
            lines.append(f'save {saved}')
    return '\n'.join(lines + ['quit'])


def stops_of(path, light):
    """In hundredths, from a session file; throws where the file is broken."""
    with open(path) as file:
        session = json.load(file)
    assert session['format'] == 'swaplight-session' and session['source'], session
    return round(100 * {one['name']: one.get('stops', 0) for one in session['rig']['lights']}[light])


def kill_after(seconds):
    """Kills a studio that long after its first step. Returns what was found: the step shown last, the step that
    would be there again, and the seconds between them. Raises AssertionError where a file is broken."""
    home = tempfile.mkdtemp(prefix='swaplight-kill-')
    try:
        with open(SAMPLE) as file:
            light = json.load(file)['lights'][0]['name']
        saved = os.path.join(home, 'mine.swaplight')
        steps = os.path.join(home, 'steps.txt')
        with open(steps, 'w') as file:
            file.write(script(light, saved))
        environment = {**os.environ, 'HOME': home}
        for name in ('XDG_CONFIG_HOME', 'XDG_DATA_HOME', 'XDG_STATE_HOME'):
            environment.pop(name, None)
        process = subprocess.Popen([PROGRAM, 'studio', '--screenshot', os.path.join(home, 'end.png'), '--size', '640x480',
                                    '--script', steps], env=environment, stderr=subprocess.PIPE, text=True)
        said, begun = {}, threading.Event()

        def listen():
            for line in process.stderr:
                if line.strip().isdigit():
                    said[int(line)] = time.time()
                    begun.set()

        listener = threading.Thread(target=listen)
        listener.start()
        assert begun.wait(60), 'the studio did not begin'
        time.sleep(seconds)
        process.send_signal(signal.SIGKILL)
        killed = time.time()
        process.wait()
        listener.join()
        process.stderr.close()

        again = 0
        if os.path.exists(saved):
            again = stops_of(saved, light)
        recovered = glob.glob(os.path.join(home, '.local/state/swaplight/recovery/*.swaplight'))
        assert len(recovered) <= 1, recovered
        for path in recovered:
            again = max(again, stops_of(path, light))
            info = subprocess.run([PROGRAM, 'info', path, '--json'], capture_output=True, text=True)
            assert info.returncode == 0, info.stderr
        shown = max(said)
        lost = killed - said[again + 1] if again < shown else 0
        return {'shown': shown, 'again': again, 'seconds_lost': round(lost, 2), 'recovered': bool(recovered)}
    finally:
        shutil.rmtree(home, ignore_errors=True)
