// SPDX-License-Identifier: Apache-2.0
// Windows, doors and their parts. Each is an element with its opening, outline and control points.
#pragma once
#include <cstdint>

#include "kernels/core/rng.h"
#include "scan/facades/facade_builder.h"

namespace ilot::scan {

// The classes that the scene uses for the pieces of a window.
struct WindowClasses {
  std::uint8_t reveal = 0, sill = 0, lintel = 0, other = 0;
};

struct WindowStyle {
  WindowClasses classes;
  Material wall = Material::limestone;  // of reveals, sill and lintel
  double recess = 0.25;                 // of the frame behind the facade, metres
  int panes_across = 2, panes_up = 3;
  double sill_out = 0, sill_height = 0.1, sill_beside = 0.07;       // sill_out 0 = none
  double lintel_out = 0, lintel_height = 0.2, lintel_beside = 0.1;  // lintel_out 0 = none
  double surround_out = 0, surround_width = 0.16;                   // a raised border; 0 = none
  double railing = 0;                                               // height of an iron railing, 0 = none
  double curtains = 0.5;                                            // greatest share of the width that curtains hide
  double room_beside = 0.6;                                         // how much wider the room behind is, on either side
  Material glass = Material::glass;
  bool framed = true;          // without it there are panes only
  double frame = 0.05;         // width of the frame
  double blind = 0;            // share of the height that a roller blind hides, from the top
  double blind_before = 0.03;  // metres from the frame to the blind
  std::uint8_t tone = 0;       // of the wall's material
  double wall_swing = 0;       // metres by which a rough wall stands out; reveals begin there
};

struct Place {
  std::uint32_t row = 0, column = 0;
};

// Adds a window in an opening that the wall already has. Behind its panes there is a room, and rng decides about
// curtains. Adds the control points window_top and window_bottom at the corners of the opening, and sill_top and
// sill_bottom at the front corners of the sill. Returns the element of the window.
std::uint32_t add_window(FacadeBuilder& facade, const Opening& opening, Place place, const WindowStyle& style,
                         Rng& rng);

// Adds a wooden door or a shop front in an opening that the wall already has.
enum class DoorKind { door, shop };
std::uint32_t add_door(FacadeBuilder& facade, const Opening& opening, Place place, DoorKind kind,
                       const WindowStyle& style, Rng& rng);

// Adds an iron railing along the facade.
void add_railing(FacadeBuilder& facade, double x0, double x1, double out, double z, double height,
                 const Finish& finish);

}  // namespace ilot::scan
