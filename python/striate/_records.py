"""What is read out of files and runs: dicts whose entries are attributes, too."""


class Record(dict):
    """A dict whose entries can be read as attributes: `landmark.name` is `landmark["name"]`."""

    def __getattr__(self, name):
        try:
            return self[name]
        except KeyError:
            raise AttributeError(f"{type(self).__name__} has no {name!r}; it has: {', '.join(self)}") from None

    def __dir__(self):
        return [*super().__dir__(), *self]

    def __repr__(self):
        return f"{type(self).__name__}({dict.__repr__(self)})"


class Landmark(Record):
    """A landmark of long-term memory.

    id, session (in which it was learned), name, kind ('taught' or 'candidate'), position (dict x_m,
    y_m, var_x_m2, cov_xy_m2, var_y_m2; None: not on the map yet), strength (0..1), uses,
    first_use_s, recent_uses_s (operating time, newest first), pinned, retired_s (None: it is not
    forgotten), retired_why, views, keypoints (counts), activation.
    """


class Episode(Record):
    """What happened: id, session, time_s (operating time), kind, x_m, y_m, heading_rad, landmark, text."""


class Session(Record):
    """A stretch of time in which one program wrote into the memory.

    id, kind, state, started_unix_s, operating_start_s, operating_s, software, settings, outcome.
    """


class Route(Record):
    """From one landmark (its id) to the next, as it was driven.

    from (read it as route["from"]), to, distance_m, turn_rad, distance_var_m2, turn_var_rad2,
    successes, failures.
    """


class ObstacleCell(Record):
    """A cell of the map's obstacles, OBSTACLE_CELL_M wide: column, row (of x and y), log_odds, seen_s."""


class KnownThing(Record):
    """A landmark that an image shows.

    name, view (which of its views agrees best, from 0), inliers (keypoints that agree), score (0..1),
    matched (0..1 of the view's keypoints), scale (pixels of the image a pixel of the view),
    turned_rad (from +u towards +v), quad (four corners [u, v], px: left upper, right upper, right
    lower, left lower).
    """


class RunResult(Record):
    """What came of a mission: the entries of the result's JSON (`striate run --result`).

    outcome ('success', 'collision', 'task_failed', ...), reason, reached_goal, distance_m,
    duration_s, cycles, longest_stand_s, ...; where a judge watched also collisions, nearest_pass_m
    and seed.
    """

    def __init__(self, entries, text, losses, notices):
        super().__init__(entries)
        self._texts = (text, losses, notices)

    @property
    def json(self):
        """The text that `striate run --result` writes."""
        return self._texts[0]

    @property
    def losses(self):
        """What could not be written down (recording, memory, result), a line each; '': nothing."""
        return self._texts[1]

    @property
    def notices(self):
        """What was read but should be written otherwise; '': nothing."""
        return self._texts[2]
