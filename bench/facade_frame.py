# SPDX-License-Identifier: Apache-2.0
"""Positions in the axes of a facade, as its JSON file states them."""


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def in_axes(frame, place):
    d = [a - b for a, b in zip(place, frame["origin"])]
    return tuple(dot(d, frame[axis]) for axis in ("right", "up", "out"))


def overlap(a, b):
    """Intersection over union of two boxes: least and greatest along, least and greatest up; what follows is not used."""
    width, height = (min(a[k + 1], b[k + 1]) - max(a[k], b[k]) for k in (0, 2))
    if width <= 0 or height <= 0:
        return 0
    area = lambda box: (box[1] - box[0]) * (box[3] - box[2])
    return width * height / (area(a) + area(b) - width * height)
