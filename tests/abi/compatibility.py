"""Whether programs that were built against one version of the interface run with another: the rules of capi/ABI.md."""


def _bytes(says):
    """Where a field begins and ends."""
    offset, size = map(int, says.split()[:2])
    return offset, offset + size


def _size_and_growth(says):
    size, growth = says.split(" ", 1)
    return int(size), growth


def _fields(facts, struct):
    return {about[2]: says for about, says in facts.items() if about[:2] == ("field", struct)}


def _given_a_use(place, struct, new):
    """A reserved field may become others of the same bytes: callers left zero in it."""
    begin, end = _bytes(place)
    inside = [_bytes(says) for says in _fields(new, struct).values() if begin <= _bytes(says)[0] < end]
    return sum(e - b for b, e in inside) == end - begin and all(e <= end for _, e in inside)


def _field_removed(about, says, new):
    _, struct, name = about
    used = name.startswith("reserved") and ("struct", struct) in new and _given_a_use(says, struct, new)
    return [] if used else [f"field {struct}.{name} was removed"]


def _struct_changed(name, before, after):
    old_size, old_growth = _size_and_growth(before)
    new_size, new_growth = _size_and_growth(after)
    if new_growth != old_growth:
        return [f"struct {name} was {old_growth!r} and is {new_growth!r}"]
    if new_size < old_size or (new_size > old_size and old_growth == "fixed"):
        return [f"struct {name} had {old_size} bytes and has {new_size}"]
    return []


def _field_added(about, says, old):
    """Behind the end, where older programs have nothing: padding that was there before holds whatever it may."""
    _, struct, name = about
    if ("struct", struct) not in old:
        return []
    begin, end = _bytes(says)
    reserved = [_bytes(place) for field, place in _fields(old, struct).items() if field.startswith("reserved")]
    behind = begin >= _size_and_growth(old["struct", struct])[0]
    if behind or any(b <= begin and end <= e for b, e in reserved):
        return []
    return [f"field {struct}.{name} was put where {struct} had other bytes"]


def _function_added(about, says, released):
    version = says.split()[0]
    return [f"function {about[1]} was added to {version}, which is released"] if version in released else []


def _removed_or_changed(about, says, new):
    if about not in new:
        return _field_removed(about, says, new) if about[0] == "field" else [f"{' '.join(about)} was removed"]
    if new[about] == says:
        return []
    if about[0] == "struct":
        return _struct_changed(about[1], says, new[about])
    return [f"{' '.join(about)} was {says!r} and is {new[about]!r}"]


def breaks(old, new, released=()):
    """One sentence for each thing that breaks programs of the old interface; `released` are versions of symbols that
    take no more functions. Another soname is another library, which breaks nothing."""
    if old["soname",] != new["soname",]:
        return []
    found = [sentence for about, says in old.items() for sentence in _removed_or_changed(about, says, new)]
    for about, says in new.items():
        if about not in old and about[0] == "field":
            found += _field_added(about, says, old)
        elif about not in old and about[0] == "function":
            found += _function_added(about, says, released)
    return found


def additions(old, new):
    """What else is different: one sentence each."""
    grown = [f"{' '.join(about)}: {says} was {old[about]}" for about, says in new.items()
             if about in old and says != old[about]]
    return grown + [f"{' '.join(about)} is new" for about in new if about not in old]
