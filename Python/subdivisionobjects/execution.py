# SPDX-License-Identifier: BSD-3-Clause
"""While a filter runs: its errors and warnings become those of Python, its progress is told, and Ctrl+C stops it."""

import contextlib
import re
import signal
import sys
import threading
import warnings

from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm


def warn(message):
    """Warns who called the package."""
    frame, level = sys._getframe(), 1
    while frame.f_back and frame.f_globals.get("__name__", "").split(".")[0] in (__package__, "contextlib"):
        frame, level = frame.f_back, level + 1
    warnings.warn(message, stacklevel=level)


def of_input_type(made, text):
    """What the pipeline says of an input that the filter does not take, without the words of pipelines."""
    found = re.match(
        r"Input for connection index \d+ on input port index (\d+) for algorithm .+ is of type (\w+)", text
    )
    if not found:
        return text
    port, key = int(found[1]), vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE()
    information = made.GetInputPortInformation(port)
    types = [information.Get(key, i) for i in range(information.Length(key))]
    cure = ""
    if "vtkUnstructuredGrid" in types and made.GetInputDataObject(port, 0).IsA("vtkDataSet"):
        cure = "; vtkmodules.vtkFiltersCore.vtkAppendFilter makes a vtkUnstructuredGrid of other data sets"
    return f"input port {port} is a {found[2]}, but can only be {', '.join(types)}{cure}"


def replace(words, text):
    """The text with other words; where several fit, the longest is meant."""
    if not words:
        return text
    # Where ParaView's plugin is loaded, too, messages have the labels of panels.
    known = set(words.values())
    text = re.sub(
        r'"([A-Z][A-Za-z0-9 -]*)"',
        lambda found: next((name for name in [re.sub("[ -]", "_", found[1].lower())] if name in known), found[0]),
        text,
    )
    any_word = "|".join(map(re.escape, sorted(words, key=len, reverse=True)))
    return re.sub(rf"(?<![^\W_])(?:{any_word})(?![^\W_])", lambda found: words[found[0]], text)


def to_callable(progress):
    """What is called with the part that is done, from 0 to 1, and what is called at the end. True is a bar of tqdm."""
    if progress is None or progress is False:
        return None, lambda: None
    if callable(progress):
        return progress, lambda: None
    if progress is not True:
        raise ValueError(
            f"progress is a function of the part that is done, or True for a bar of tqdm, not {progress!r}"
        )
    try:
        from tqdm.auto import tqdm
    except ImportError:
        raise ValueError("progress=True needs tqdm, which is not installed: give a function, such as print") from None
    bar = tqdm(total=100, unit="%")
    return lambda done: bar.update(round(100 * done) - bar.n), bar.close


class Stopper:
    """Stops a filter at its next report of progress after Ctrl+C, or after an exception of what is told of progress.

    No exception may leave an observer: VTK would end the process. So the handler of SIGINT is called inside of another
    one that keeps its exception for the end.
    """

    def __init__(self, made, progress):
        self.made, self.error = made, None
        self.tell, self.close = to_callable(progress)
        self.previous = None

    def begin(self):
        self.observer = self.made.AddObserver("ProgressEvent", self.report)
        if threading.current_thread() is threading.main_thread() and callable(signal.getsignal(signal.SIGINT)):
            self.previous = signal.signal(signal.SIGINT, self.interrupt)

    def interrupt(self, number, frame):
        self.guard(lambda: self.previous(number, frame))

    def report(self, *_):
        if self.tell and not self.error:
            self.guard(lambda: self.tell(self.made.GetProgress()))
        if self.error:
            self.made.SetAbortExecute(True)

    def guard(self, call):
        try:
            call()
        except BaseException as error:
            self.error = self.error or error

    def end(self):
        self.made.RemoveObserver(self.observer)
        if self.previous:
            signal.signal(signal.SIGINT, self.previous)
        self.close()
        if self.error:
            self.made.SetAbortExecute(False)  # which would stop what is asked of it next


@contextlib.contextmanager
def listen_to(made, words=None, progress=None):
    """Errors become an exception, warnings those of Python, told to who called the function that calls this. `words` of
    the messages are replaced by those of the caller. Ctrl+C and exceptions of `progress` stop the filter."""
    told = {"ErrorEvent": [], "WarningEvent": []}

    @calldata_type(VTK_STRING)
    def listen(_, event, message):
        if "returned failure for request" not in message:  # the pipeline says once more that something failed
            text = re.sub(r"\A(ERROR|Warning): In .*\n\S+ \(\w+\): ", "", message).strip()
            told[event].append(replace(words, of_input_type(made, text)))

    sources = [one for one in (made, made.GetExecutive()) if one]
    observers = [(source, source.AddObserver(event, listen)) for source in sources for event in told]
    stopper = Stopper(made, progress)
    stopper.begin()
    try:
        yield told
    finally:
        stopper.end()
        for source, observer in observers:
            source.RemoveObserver(observer)
    if stopper.error:
        raise stopper.error
    for message in told["WarningEvent"]:
        warn(message)
    if told["ErrorEvent"]:
        raise RuntimeError("\n".join(told["ErrorEvent"]))
