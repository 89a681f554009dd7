"""drop.py WINDOW FILE...: lets files fall on a window, as a file manager does (XDND version 5)."""

import sys
import time
from pathlib import Path

from Xlib import X, Xatom, display
from Xlib.protocol import event

VERSION = 5
PATIENCE = 30.0  # s


class Source:
    """What is dragged: a window of ours that owns the selection."""

    def __init__(self, target, files):
        self.display = display.Display()
        self.target = self.display.create_resource_object("window", target)
        self.window = self.display.screen().root.create_window(0, 0, 1, 1, 0, X.CopyFromParent)
        self.window.set_selection_owner(self.atom("XdndSelection"), X.CurrentTime)
        self.text = "".join(f"{Path(file).resolve().as_uri()}\r\n" for file in files).encode()

    def atom(self, name):
        return self.display.get_atom(name)

    def send(self, kind, *numbers):
        data = (32, [self.window.id, *numbers] + [0] * (4 - len(numbers)))
        message = event.ClientMessage(window=self.target, client_type=self.atom(kind), data=data)
        self.target.send_event(message)
        self.display.flush()

    def answer(self, request):
        """The names of the files, to the window that asks for them."""
        requestor = self.display.create_resource_object("window", request.requestor.id)
        requestor.change_property(request.property, request.target, 8, self.text)
        requestor.send_event(event.SelectionNotify(time=request.time, requestor=requestor.id,
                                                   selection=request.selection, target=request.target,
                                                   property=request.property))
        self.display.flush()

    def wait_for(self, kind):
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            if not self.display.pending_events():
                time.sleep(0.01)
                continue
            came = self.display.next_event()
            if came.type == X.SelectionRequest:
                self.answer(came)
            elif came.type == X.ClientMessage and came.client_type == self.atom(kind):
                return came.data[1]
        raise SystemExit(f"the window does not answer with {kind}")

    def drop(self, x, y):
        aware = self.target.get_full_property(self.atom("XdndAware"), Xatom.ATOM)
        if not aware or aware.value[0] < VERSION:
            raise SystemExit("the window takes no files")
        self.send("XdndEnter", VERSION << 24, self.atom("text/uri-list"))
        self.send("XdndPosition", 0, x << 16 | y, X.CurrentTime, self.atom("XdndActionCopy"))
        if not self.wait_for("XdndStatus")[1] & 1:
            raise SystemExit("the window refuses")
        self.send("XdndDrop", 0, X.CurrentTime)
        self.wait_for("XdndFinished")


if __name__ == "__main__":
    Source(int(sys.argv[1]), sys.argv[2:]).drop(400, 300)
