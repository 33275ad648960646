// What lies along a surface: a face, edge or axis within 2.9° of it touches it all along, so that what rests a little
// tilted keeps the points that carry it.
#pragma once

namespace sudar {

inline constexpr double flat_sine = 0.05, flat_cosine = 0.99875;

}
