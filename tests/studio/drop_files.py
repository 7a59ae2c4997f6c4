"""Drops files onto a window as a desktop does: the source's side of the XDND protocol, version 5."""
import time

from Xlib import X, display
from Xlib.protocol import event


def find_window(xd, root, title):
    for window in root.query_tree().children:
        name = window.get_full_property(xd.intern_atom('_NET_WM_NAME'), xd.intern_atom('UTF8_STRING'))
        if name and title in name.value.decode():
            return window
        inner = find_window(xd, window, title)
        if inner:
            return inner
    return None


def drop_files(display_name, title, paths, x, y):
    """Drops files onto the window whose title has these words, at a place of the screen."""
    xd = display.Display(display_name)
    atom = xd.intern_atom
    root = xd.screen().root
    target = find_window(xd, root, title)
    assert target, f'there is no window {title!r}'
    source = root.create_window(0, 0, 1, 1, 0, X.CopyFromParent)
    source.set_selection_owner(atom('XdndSelection'), X.CurrentTime)
    uris = ''.join(f'file://{path}\r\n' for path in paths).encode()

    def send(kind, *values):
        message = event.ClientMessage(window=target, client_type=atom(kind), data=(32, (source.id, *values)))
        target.send_event(message)
        xd.flush()

    def answer_until(kind, seconds=10):
        """Gives the data when asked for it, until the window has said this."""
        end = time.time() + seconds
        while time.time() < end:
            if not xd.pending_events():
                time.sleep(0.02)
                continue
            got = xd.next_event()
            if got.type == X.SelectionRequest:
                got.requestor.change_property(got.property, got.target, 8, uris)
                got.requestor.send_event(event.SelectionNotify(
                    time=got.time, requestor=got.requestor, selection=got.selection, target=got.target,
                    property=got.property))
                xd.flush()
            elif got.type == X.ClientMessage and got.client_type == atom(kind):
                return
        raise AssertionError(f'the window did not answer with {kind}')

    send('XdndEnter', 5 << 24, atom('text/uri-list'), 0, 0)
    send('XdndPosition', 0, (x << 16) | y, X.CurrentTime, atom('XdndActionCopy'))
    answer_until('XdndStatus')
    send('XdndDrop', 0, X.CurrentTime, 0, 0)
    answer_until('XdndFinished')
    xd.close()
