# SPDX-License-Identifier: MIT
"""The window of a running program, seen from the X server: its picture, and a key pressed in it.

Needs no window manager. A key goes to the window itself as a sent event, so that programs at work beside this
one (on the same display) neither steal nor get it.
"""
import time

from Xlib import X, XK, display, error
from Xlib.ext import xtest
from Xlib.protocol import event

POLL_INTERVAL_S = 0.05


class Window:
    """The top-level window of a given size: sizes are chosen so that no other program has the same.

    Use as a context manager: it ends the connection to the server.
    """

    def __init__(self, size, timeout_s=30):
        """Wait until a window of exactly `size` (width, height) is on the screen."""
        self.display = display.Display()
        self.size = size
        deadline = time.monotonic() + timeout_s
        while (window := self._find()) is None:
            if time.monotonic() > deadline:
                raise TimeoutError(f"no window of {size[0]}x{size[1]} appeared")
            time.sleep(POLL_INTERVAL_S)
        self.window = window

    def __enter__(self):
        return self

    def __exit__(self, *unused):
        self.display.close()

    def _find(self):
        root = self.display.screen().root
        for window in root.query_tree().children:
            try:
                shown = window.get_attributes().map_state == X.IsViewable
                geometry = window.get_geometry()
            except error.BadWindow:  # gone between the two requests
                continue
            if shown and (geometry.width, geometry.height) == self.size:
                return window
        return None

    def picture(self):
        """The window's pixels as the server stores them: bytes, 4 a pixel, rows from the top."""
        return self.window.get_image(0, 0, *self.size, X.ZPixmap, 0xFFFFFFFF).data

    def picture_at_rest(self, timeout_s=30):
        """The picture once it has not changed for half a second."""
        deadline = time.monotonic() + timeout_s
        last, since = self.picture(), time.monotonic()
        while time.monotonic() < deadline:
            time.sleep(POLL_INTERVAL_S)
            now = self.picture()
            if now != last:
                last, since = now, time.monotonic()
            elif time.monotonic() - since > 0.5:
                return now
        raise TimeoutError("the picture never came to rest")

    def press(self, key):
        """Press and release a key by its X name, such as Escape."""
        code = self.display.keysym_to_keycode(XK.string_to_keysym(key))
        for kind, mask in ((event.KeyPress, X.KeyPressMask), (event.KeyRelease, X.KeyReleaseMask)):
            self.window.send_event(
                kind(time=X.CurrentTime, root=self.display.screen().root, window=self.window, same_screen=1,
                     child=X.NONE, root_x=0, root_y=0, event_x=1, event_y=1, state=0, detail=code),
                event_mask=mask)
        self.display.sync()  # the server has it before this connection ends

    def close(self):
        """Ask the program to end, as a window manager's close button does."""
        atoms = [self.display.intern_atom(name) for name in ("WM_PROTOCOLS", "WM_DELETE_WINDOW")]
        self.window.send_event(event.ClientMessage(window=self.window, client_type=atoms[0],
                                                   data=(32, [atoms[1], X.CurrentTime, 0, 0, 0])))
        self.display.sync()

    def point(self, x, y, button=None, wait_s=0.2):
        """Move the display's one pointer and click: for programs that have the display for themselves."""
        xtest.fake_input(self.display, X.MotionNotify, x=x, y=y)
        self.display.sync()
        time.sleep(wait_s)
        for kind in (X.ButtonPress, X.ButtonRelease) if button else ():
            xtest.fake_input(self.display, kind, button)
            self.display.sync()
            time.sleep(wait_s)
