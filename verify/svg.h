// Curves as SVG, coloured by the page's style sheet (classes theory, dots, axis, grid).
#pragma once

#include "verify/case.h"

namespace sudar::verify {

using Points = std::vector<std::pair<double, double>>;

// The theory as a line, the simulation as dots over it.
std::string draw_curves(const Plot&);

// Error against the length of a sub-step, both logarithmic, with the line that the order demands.
std::string draw_convergence(const Points& sweep, double order);

// What would be read as markup, escaped.
std::string escaped(std::string_view);

}
