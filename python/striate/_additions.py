"""Behaviours and conditions of your own, for task scripts."""

import inspect

from ._errors import UserError
from ._striate import _add_behaviour, _add_condition


class Argument:
    """An argument of an action, as task scripts give it: `- nod: {tilt: 10 deg}`.

    default: its value in SI units; its type says what is read: a float a quantity, an int a count, a
    bool yes or no, a str a text.  unit: 'none', 'length', 'duration', 'angle', 'speed', 'turn_rate',
    'acceleration', 'turn_acceleration', 'rate', 'fraction' or 'pixels'.  low, high: its range,
    inclusive.  choices: the words that a str may be.  help: one line.
    """

    def __init__(self, default, unit="none", low=-1e9, high=1e9, help="", choices=()):
        self.default = default
        self.unit = unit
        self.low = low
        self.high = high
        self.help = help
        self.choices = list(choices)


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
    Raises UserError for a name that is taken or none.
    """

    for word, one in (arguments or {}).items():
        if not isinstance(one, Argument):
            raise TypeError(f"argument {word!r} must be a striate.Argument, not {type(one).__name__}")

    def add(cls):
        _add_behaviour(name, cls, help or _first_line(cls), dict(arguments or {}), main,
                       list(required), motors, ends_by_itself, can_fail)
        return cls

    return add


class _FunctionCondition:
    def __init__(self, function, limit):
        self._function = function
        self._limit = limit

    def holds(self, memory):
        return self._function(memory, self._limit)


def condition(name, *, unit="none", low=-1e9, high=1e9, example="1", help=""):
    """Makes a function or a class a condition of task scripts: `until: {near_something: 2 m}`.

    A function is called once a cycle as function(memory, limit) and returns whether it holds. A class
    is made as cls(limit), has holds(memory), and may have start(memory), called when the step that it
    belongs to starts.

    name: a lower_case_word that no condition has; one of your own is replaced.  unit: of the limit,
    as for Argument.  low, high: its range, SI units.  example: a value.  help: one line.
    Raises UserError for a name that is taken or none.
    """

    if not low <= high:
        raise UserError(f"a condition {name!r} with a range from {low} to {high}, in which nothing lies")

    def add(what):
        make = what if inspect.isclass(what) else lambda limit: _FunctionCondition(what, limit)
        _add_condition(name, make, help or _first_line(what), unit, low, high, example)
        return what

    return add
