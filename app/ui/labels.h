// The names of bodies over the picture; of a body without one its number.
#pragma once

#include "ui/hand.h"

namespace sudar::ui {

void draw_labels(const Controls&, const Area&);

}
