"""The errors that Striate raises."""

import re

_PLACE = re.compile(r"^(?P<file>[^\n]*?):(?P<line>\d+):(?P<column>\d+): (?P<message>[^\n]*)", re.M)


class Problem:
    """One mistake in a file: `file`, `line` and `column` (from 1), `message`."""

    def __init__(self, file, line, column, message):
        self.file = file
        self.line = line
        self.column = column
        self.message = message

    def __repr__(self):
        return f"Problem({self.file!r}, {self.line}, {self.column}, {self.message!r})"


class UserError(ValueError):
    """A mistake in what was given, told in the sentence of the command line (exit code 2).

    `problems` lists the mistakes that have a place in a file; `file`, `line` and `column` are the
    first one's, None where there is none.
    """

    @property
    def problems(self):
        """A Problem for each mistake that has a place in a file."""
        return [
            Problem(found["file"], int(found["line"]), int(found["column"]), found["message"])
            for found in _PLACE.finditer(str(self))
        ]

    @property
    def file(self):
        """Of the first problem; None: no place is known."""
        return self.problems[0].file if self.problems else None

    @property
    def line(self):
        """Of the first problem, from 1; None: no place is known."""
        return self.problems[0].line if self.problems else None

    @property
    def column(self):
        """Of the first problem, from 1; None: no place is known."""
        return self.problems[0].column if self.problems else None
