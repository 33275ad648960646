#include "bench/meter.h"

#include <algorithm>

namespace sudar::bench {

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void PassMeter::after_step(const Profile::Passes& p) {
  used_.push_back(double(p.used));
  us_.push_back(p.microseconds);
  if (p.visits > 0) ns_per_visit_.push_back(1000 * p.microseconds / double(p.visits));
}

void Meter::after_step(const World& world) {
  const Profile& p = world.profile();
  double total = 0;
  for (const Profile::Stage& stage : p.stages) {
    total += stage.microseconds;
    const auto known =
        std::find_if(stage_sums_.begin(), stage_sums_.end(), [&](const Stage& s) { return s.name == stage.name; });
    if (known != stage_sums_.end())
      known->microseconds += stage.microseconds;
    else
      stage_sums_.push_back({stage.name, stage.microseconds});
  }
  step_us_.push_back(total);
  awake_.push_back(double(p.awake));
  contacts_.push_back(double(p.contacts));
  points_.push_back(double(p.points));
  collision_.after_step(p.collision);
  contact_.after_step(p.contact);
  correction_.after_step(p.correction);
  joint_.after_step(p.joint);

  const Quality q = world.quality();
  worst_.penetration_max = max(worst_.penetration_max, q.penetration_max);
  worst_.joint_gap_max = max(worst_.joint_gap_max, q.joint_gap_max);
  sum_.penetration_mean += q.penetration_mean;
  sum_.joint_gap_mean += q.joint_gap_mean;
}

double Meter::step_us_min() const { return step_us_.empty() ? 0 : *std::min_element(step_us_.begin(), step_us_.end()); }
double Meter::awake_min() const { return awake_.empty() ? 0 : *std::min_element(awake_.begin(), awake_.end()); }

std::vector<Meter::Stage> Meter::stages() const {
  std::vector<Stage> means = stage_sums_;
  for (Stage& s : means) s.microseconds /= double(steps());
  return means;
}

Quality Meter::mean() const {
  const Real n = Real(std::max<std::int64_t>(steps(), 1));
  Quality q;
  q.penetration_mean = sum_.penetration_mean / n;
  q.joint_gap_mean = sum_.joint_gap_mean / n;
  return q;
}

}
