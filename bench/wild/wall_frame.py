# SPDX-License-Identifier: Apache-2.0
"""The axes of a wall, and boxes in them: left, right, bottom, top, and the range of distances from the wall."""
import math


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    length = math.sqrt(dot(a, a))
    return [x / length for x in a]


class Frame:
    """The axes of a wall: right, up, out of it towards the stations."""

    def __init__(self, ring, stations):
        total = [0, 0, 0]
        for a, b in zip(ring[1:], ring[2:]):
            total = [t + c for t, c in zip(total, cross(minus(a, ring[0]), minus(b, ring[0])))]
        self.origin, self.out = ring[0], unit(total)
        if sum(dot(minus(s, ring[0]), self.out) > 0 for s in stations) * 2 < len(stations):
            self.out = [-x for x in self.out]
        self.right = unit(cross([0, 0, 1], self.out))
        self.up = cross(self.out, self.right)

    def flat(self, p):
        d = minus(p, self.origin)
        return dot(d, self.right), dot(d, self.up), dot(d, self.out)

    def box(self, ring):
        flat = [self.flat(p) for p in ring]
        return tuple(f(p[k] for p in flat) for k in (0, 1, 2) for f in (min, max))


def area(b):
    return max(0, b[1] - b[0]) * max(0, b[3] - b[2])


def common(a, b):
    return area((max(a[0], b[0]), min(a[1], b[1]), max(a[2], b[2]), min(a[3], b[3])))


def iou(a, b):
    both = common(a, b)
    return both / (area(a) + area(b) - both) if both else 0
