#include "verify/peers.h"

#include <cstdio>

namespace sudar::verify {

namespace {

std::string format(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text[0] == '-' ? "−" + std::string(text + 1) : text;
}
std::string plain(const Quantity& q) { return format("%#.6g", q.got); }
std::string percent(const Quantity& q) { return format("%+.3f %%", q.got); }
std::string deviation(const Quantity& q) { return format("%+.2f %%", 100 * (q.got / q.exact - 1)); }
std::string millimetres(const Quantity& q) { return format("%.3f mm", 1000 * q.got); }

}

const std::vector<PeerColumn>& peer_columns() {
  static const std::vector<PeerColumn> columns = {
      {"V07 energy, 60 s (0)", "V07", "defaults", "change of the energy", percent},
      {"V13 apex 1 (0)", "V13", "defaults", "apex 1", deviation},
      {"V14 slip (2.4 m/s)", "V14", "slip", "velocity along the floor", plain},
      {"V16 way (4.2474 m)", "V16", "defaults", "way at 0°, discrete law", plain},
      {"V17 rolling (5 m/s)", "V17", "defaults", "velocity of rolling", plain},
      {"V35 across (0.48273 m)", "V35", "defaults", "way across", plain},
      {"V53 at 2 s (0)", "V53", "defaults", "distance from the exact place at 2 s", millimetres},
      {"V30 way (1.383 m)", "V30", "defaults", "way along", plain},
      {"V43 1000 : 1 (1.5 m)", "V43", "1000", "height of the heavy cube", plain},
      {"V13b bounce, 1 ms (185 J²)", "V13b", "1 ms", "mean squared error of the energy", plain},
  };
  return columns;
}

const std::vector<PeerRow>& peer_rows() {
  static const std::vector<PeerRow> rows = {
      {"Box3D 60/4",
       {"−3.2 … +0.6 %", "−2.4 %", "2.600", "4.23695", "4.9524", "0.47941", "3.8 mm", "0.379", "1.164", "296 518"}},
      {"Rapier", {"−66 %", "−2.4 %", "2.600", "4.23695", "4.9305", "0.47941", "3.8 mm", "0.379", "0.500", "66 120"}},
      {"Jolt", {"−90 %", "+0.1 %", "2.400", "4.20574", "4.9999", "0.46937", "2.9 mm", "0.370", "0.500", "184.5"}},
      {"Havok", {"−99 %", "−1.9 %", "2.408", "4.22587", "4.9951", "0.47857", "2.7 mm", "1.619", "0.500", "3.2e6"}},
      {"PhysX PGS", {"−89 %", "+5.5 %", "2.400", "4.20576", "5.0000", "0.46935", "–", "1.161", "0.500", "75 260"}},
      {"PhysX TGS",
       {"−2.8 … +4.0 %", "−2.9 %", "2.400", "4.20581", "5.0000", "0.46945", "2.9 mm", "1.246", "0.500", "184.8"}},
      {"Bullet", {"−66 %", "+9.6 %", "2.400", "4.16857", "4.9999", "0.46679", "4.6 mm", "1.395", "0.500", "9.8e6"}},
      {"MuJoCo", {"−60 %", "–", "–", "4.20559", "4.9632", "0.46761", "–", "1.349", "0.954", "–"}},
  };
  return rows;
}

std::string our_value(const PeerColumn& column, const std::vector<Result>& results) {
  for (const Result& r : results) {
    if (std::string_view(column.id) != r.of->id || r.set != column.set) continue;
    for (const Quantity& q : r.quantities) {
      if (q.name == column.quantity) return column.text(q);
    }
  }
  return "–";
}

}
