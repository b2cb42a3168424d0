# SPDX-License-Identifier: Apache-2.0
"""The true leaves of the windows of wild facades, and what is drawn of them."""
from wall_frame import area, common, dot


def leaves_of(frame, box, opening, truth):
    """The state of the leaves of a window and their boxes; "" for a window without leaves."""
    leaves = [(frame.box(e["ring"]), e) for e in truth["elements"] if e["kind"] == "shutter" and e["facade"] == opening["facade"]]
    # One of its upright sides is the hinge, 4 mm within the jamb.
    leaves = [(b, e) for b, e in leaves if abs(b[2] - box[2]) < 0.02 and
              min(abs(abs(s - t) - 0.004) for s in b[:2] for t in box[:2]) < 0.002]
    if not leaves:
        return "", []
    b, e = leaves[0]
    half = (box[1] - box[0]) / 2
    if b[1] < box[0] + 0.05 or b[0] > box[1] - 0.05:
        return "open", [b for b, _ in leaves]
    # The scanner leaves 6 mm of each half free where leaves are closed.
    if abs(b[1] - b[0] - (half - 0.006)) < 0.001:
        return "closed" if e["depth_m"] > 0 else "inset", [b for b, _ in leaves]
    return "half", [b for b, _ in leaves]


def are_drawn(frame, leaves, state, facades):
    """Whether elements of the kind shutter cover half of the leaves, or stand at the hinge of one that is half open."""
    covered, hinged = 0, False
    for f in facades:
        if abs(dot(f["frame"]["out"], frame.out)) < 0.98:
            continue
        for e in f["elements"]:
            if e["kind"] == "shutter":
                own = frame.box(e["ring"])
                if max(abs(own[4]), abs(own[5])) < 1:
                    covered += sum(common(own, b) for b in leaves)
                    hinged |= any(min(abs(s - t) for s in own[:2] for t in b[:2]) < 0.15 and
                                  2 * (min(own[3], b[3]) - max(own[2], b[2])) > b[3] - b[2] for b in leaves)
    return hinged if state == "half" else covered >= 0.5 * sum(area(b) for b in leaves)


def shutter_cause(e, frames, boxes, truth):
    """Whether what is drawn as a shutter is a leaf of the window that it is nearest to, or what it lies on."""
    for frame, box, o in zip(frames, boxes, truth["openings"]):
        own = frame.box(e["ring"])
        if max(abs(own[4]), abs(own[5])) > 1.3:
            continue
        state, leaves = leaves_of(frame, box, o, truth)
        if any(common((own[0] - 0.1, own[1] + 0.1, own[2], own[3]), b) > 0.3 * min(area(b), area(own) or 1) for b in leaves):
            return "a leaf"
        if not state and common(own, box) > 0.3 * area(own):
            return "within an opening without leaves"
    return "elsewhere"
