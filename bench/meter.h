// What a run costs and how well it holds, step by step: the figures that `sudar run` and `sudar bench` report.
#pragma once

#include <sudar/world.h>

#include <string>
#include <vector>

namespace sudar::bench {

// The middle one of the values, 0 of none.
double median(std::vector<double> values);

class Meter {
 public:
  explicit Meter(const World& before) : start_(before.energy()) {}
  void after_step(const World&);

  struct Stage {
    std::string name;
    double microseconds;  // mean per step
  };
  std::int64_t steps() const { return std::int64_t(step_us_.size()); }
  // The stages of a step together: without what the scenario does before and after it.
  double step_us_median() const { return median(step_us_); }
  double step_us_min() const;
  std::vector<Stage> stages() const;
  double awake_min() const;
  double awake_median() const { return median(awake_); }
  double contacts_median() const { return median(contacts_); }
  double points_median() const { return median(points_); }
  double collision_passes_median() const { return median(collision_passes_); }
  double contact_passes_median() const { return median(contact_passes_); }
  // Time in the passes alone for one contact point or one joint in one pass: median of the steps that had any, else 0.
  // (Joints asleep are counted as if they were solved: right where sleeping is off.)
  double ns_per_constraint_and_pass() const { return median(ns_per_constraint_); }
  const Energy& energy_at_start() const { return start_; }
  const Quality& worst() const { return worst_; }  // the largest of all steps' maxima
  Quality mean() const;                            // the mean of all steps' means

 private:
  Energy start_;
  std::vector<double> step_us_, awake_, contacts_, points_, collision_passes_, contact_passes_, ns_per_constraint_;
  std::vector<Stage> stage_sums_;
  Quality worst_, sum_;
};

}
