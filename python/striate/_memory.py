"""The long-term memory, opened to read."""

from . import _records
from ._striate import _Memory
from ._words import words


class Memory:
    """A long-term memory file, opened to read; also while a mission writes it.

    file: made by `striate teach` or a mission. Use it as a context manager, or close() it.
    Raises UserError where it is none, with the sentence of the command line.
    """

    def __init__(self, file):
        self._memory = _Memory(file)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        """Closes the file; views that were read stay."""
        self._memory.close()

    @property
    def path(self):
        """The file, as it was named."""
        return self._memory.path

    @property
    def closed(self):
        """Whether close() was called."""
        return self._memory.closed

    @property
    def notices(self):
        """What opening found, a sentence each: a crash, a newer version."""
        return self._memory.notices

    def landmarks(self, forgotten=False):
        """Landmark records, the most active first; forgotten ones too where asked for."""
        return [_records.Landmark(one) for one in self._memory._landmarks(forgotten)]

    def landmark(self, name):
        """The Landmark of that name, also a forgotten one. Raises KeyError where there is none."""
        for one in self.landmarks(forgotten=True):
            if one["name"] == name:
                return one
        raise KeyError(name)

    def views(self, name):
        """Views of a landmark, oldest first: keypoints, descriptors, picture. Raises UserError."""
        return self._memory._views(name)

    def episodes(self, most=-1):
        """Episode records, newest first; at most so many, -1: all."""
        return [_records.Episode(one) for one in self._memory._episodes(most)]

    def sessions(self):
        """Session records, newest first."""
        return [_records.Session(one) for one in self._memory._sessions()]

    def routes(self):
        """Route records between landmarks."""
        return [_records.Route(one) for one in self._memory._routes()]

    def obstacle_cells(self):
        """ObstacleCell records of the map, by row, then column."""
        return [_records.ObstacleCell(one) for one in self._memory._obstacle_cells()]

    def recognise(self, image, only=(), channels="bgr"):
        """Which landmarks an image shows, and where, as `striate recognise`: KnownThing records.

        image: (h, w) or (h, w, 3) uint8.  only: names that are looked for; (): all.
        Raises UserError where a name is none of the memory's.
        """
        found = self._memory._recognise(image, words(only, "only"), channels)
        return [_records.KnownThing(one) for one in found]
