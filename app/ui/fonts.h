// The panels' font and colours, set once in ImGui's context.
#pragma once

namespace sudar::ui {

// Inter, and DejaVu Sans for what Inter lacks; ImGui's own where neither is installed. Latin, Greek, Cyrillic, arrows,
// mathematical signs.
void load_fonts();

}
