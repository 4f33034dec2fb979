"""Behaviours and conditions of your own, for task scripts."""

import inspect
import math
import numbers

from ._errors import UserError
from ._striate import _add_behaviour, _add_condition
from ._words import words

_MOST_COUNT = 2**31 - 1  # of a C++ int


def _check_range(low, high):
    for bound in (low, high):
        if not isinstance(bound, numbers.Real) or isinstance(bound, bool):
            raise TypeError(f"low and high are numbers, not {bound!r}")
    if not low <= high:
        raise UserError(f"a range from {low} to {high}, in which nothing lies")


def _checked_default(default, low, high):
    """The default as one of the types that can be read."""
    if isinstance(default, (bool, str)):
        return default
    if isinstance(default, numbers.Integral):
        if not low <= default <= high or abs(default) > _MOST_COUNT:
            raise UserError(f"a default of {default}, which lies outside of its range, {low} to {high}")
        return int(default)
    if not isinstance(default, numbers.Real):
        raise TypeError(f"a default is a float, an int, a bool or a str, not {default!r}")
    if not low <= default <= high or not math.isfinite(default):
        raise UserError(f"a default of {default}, which lies outside of its range, {low} to {high}")
    return float(default)


class Argument:
    """An argument of an action, as task scripts give it: `- nod: {tilt: 10 deg}`.

    default: its value in SI units; its type says what is read: a float a quantity, an int a count, a
    bool yes or no, a str a text.  unit: 'none', 'length', 'duration', 'angle', 'speed', 'turn_rate',
    'acceleration', 'turn_acceleration', 'rate', 'fraction' or 'pixels'.  low, high: its range,
    inclusive.  choices: the words that a str may be.  help: one line.
    Raises UserError for a default outside of its range or choices, TypeError for what is none.
    """

    def __init__(self, default, unit="none", low=-1e9, high=1e9, help="", choices=()):
        _check_range(low, high)
        self.default = _checked_default(default, low, high)
        self.unit = unit
        self.low = low
        self.high = high
        self.help = help
        self.choices = words(choices, "choices")
        if self.choices and default not in self.choices:
            raise UserError(f"a default of {default!r}, which is none of its choices, {', '.join(self.choices)}")


def _first_line(of):
    return (inspect.getdoc(of) or "").partition("\n")[0]


def behaviour(name, *, arguments=None, main="", required=(), motors="both", ends_by_itself=True,
              can_fail=True, help=""):
    """Makes a class an action of task scripts: `@striate.behaviour("nod")`.

    The class is made anew for each step, as cls(arguments, robot): a dict of the step's arguments in
    SI units, and the Robot. It has tick(memory), called once a cycle, which returns a Wish; it may
    have start(memory), and halt(memory), which returns False as long as it needs to come to rest.

    name: a lower_case_word that no action has; one of your own is replaced, in missions from then on.
    arguments: dict of name to Argument.  main: the argument of `- nod: 3 s`.  required: those that
    must be given.  motors: what its wishes move: 'nothing', 'wheels', 'head' or 'both'.
    ends_by_itself, can_fail: what the checker of scripts counts on.  help: one line; without it the
    first of the class's docstring.
    Raises UserError for a name that is taken or none, TypeError for a class without tick().
    """

    required = words(required, "required")
    for word, one in (arguments or {}).items():
        if not isinstance(one, Argument):
            raise TypeError(f"argument {word!r} must be a striate.Argument, not {type(one).__name__}")

    def add(cls):
        if not inspect.isclass(cls) or not callable(getattr(cls, "tick", None)):
            raise TypeError(f"a behaviour {name!r} must be a class with tick(memory), not {cls!r}")
        _add_behaviour(name, cls, help or _first_line(cls), dict(arguments or {}), main, required, motors,
                       ends_by_itself, can_fail)
        return cls

    return add


class _FunctionCondition:
    def __init__(self, function, limit):
        self._function = function
        self._limit = limit

    def holds(self, memory):
        return self._function(memory, self._limit)


def condition(name, *, unit="none", low=-1e9, high=1e9, example="", help=""):
    """Makes a function or a class a condition of task scripts: `until: {near_something: 2 m}`.

    A function is called once a cycle as function(memory, limit) and returns whether it holds. A class
    is made as cls(limit), has holds(memory), and may have start(memory), called when the step that it
    belongs to starts.

    name: a lower_case_word that no condition has; one of your own is replaced.  unit: of the limit,
    as for Argument.  low, high: its range, SI units.  example: a value; without it one in the range.
    help: one line.
    Raises UserError for a name that is taken or none, and for an example that cannot be read;
    TypeError for what is neither a function nor a class with holds().
    """

    _check_range(low, high)

    def add(what):
        is_class = inspect.isclass(what)
        if not callable(getattr(what, "holds", None) if is_class else what):
            raise TypeError(f"a condition {name!r} must be a function, or a class with holds(memory), not {what!r}")
        make = what if is_class else lambda limit: _FunctionCondition(what, limit)
        _add_condition(name, make, help or _first_line(what), unit, low, high, example)
        return what

    return add
