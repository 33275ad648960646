// What a run costs and how well it holds, step by step: the figures that `sudar run` and `sudar bench` report.
#pragma once

#include <sudar/world.h>

#include <string>
#include <vector>

namespace sudar::bench {

// The middle one of the values, 0 of none.
double median(std::vector<double> values);

// Passes of one kind (Profile::Passes), medians over the steps.
class PassMeter {
 public:
  void after_step(const Profile::Passes&);
  double used() const { return median(used_); }
  double us_per_step() const { return median(us_); }
  double ns_per_visit() const { return median(ns_per_visit_); }  // of the steps that had visits, else 0

 private:
  std::vector<double> used_, us_, ns_per_visit_;
};

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
  const PassMeter& collision() const { return collision_; }
  const PassMeter& contact() const { return contact_; }
  const PassMeter& correction() const { return correction_; }
  const PassMeter& joint() const { return joint_; }
  const Energy& energy_at_start() const { return start_; }
  const Quality& worst() const { return worst_; }  // the largest of all steps' maxima
  Quality mean() const;                            // the mean of all steps' means

 private:
  Energy start_;
  std::vector<double> step_us_, awake_, contacts_, points_;
  PassMeter collision_, contact_, correction_, joint_;
  std::vector<Stage> stage_sums_;
  Quality worst_, sum_;
};

}
