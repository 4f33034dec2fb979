"""Lists of words that people give."""


def words(given, name):
    """A list of them. Raises TypeError for one str, whose letters would be taken for words."""
    if isinstance(given, (str, bytes)):
        raise TypeError(f"{name}: give a list of words, [{given!r}], not {given!r}")
    given = list(given)
    for one in given:
        if not isinstance(one, str):
            raise TypeError(f"{name}: {one!r} is no word")
    return given
