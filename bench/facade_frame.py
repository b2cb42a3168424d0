# SPDX-License-Identifier: Apache-2.0
"""Positions in the axes of a facade, as its JSON file states them."""


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def in_axes(frame, place):
    d = [a - b for a, b in zip(place, frame["origin"])]
    return tuple(dot(d, frame[axis]) for axis in ("right", "up", "out"))
