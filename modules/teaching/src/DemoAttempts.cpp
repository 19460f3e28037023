#include <insonate/core/Hash.h>
#include <insonate/curriculum/Judgement.h>
#include <insonate/curriculum/Unlocking.h>
#include <insonate/teaching/DemoClass.h>
#include <insonate/teaching/TeachingHere.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace insonate {
namespace {

constexpr int kSession = 5;  // attempts in one afternoon
constexpr std::int64_t kMinute_us = 60'000'000, kDay_us = 24 * 60 * kMinute_us,
                       kMorning_us = 9 * 60 * kMinute_us;  // UTC

/// Pseudorandom numbers that are the same on every computer.
class Dice {
 public:
  Dice(std::uint32_t seed, int trainee) : state_(hash32(seed ^ hash32(static_cast<std::uint32_t>(trainee) + 1))) {}

  double between(double low, double high) { return low + (high - low) * unitInterval(hash32(++state_)); }
  bool happens(double probability) { return between(0, 1) < probability; }
  /// Standard normal, by Box and Muller.
  double normal() {
    const double radius = std::sqrt(-2 * std::log(between(1e-12, 1)));
    return radius * std::cos(between(0, 2 * std::numbers::pi));
  }

 private:
  std::uint32_t state_;
};

struct Trainee {
  double begins, becomes, rate;  ///< position between novice (0) and expert (1)

  double skill(int attempt) const { return becomes - (becomes - begins) * std::pow(attempt, -rate); }
};

/// Range of a metric without a norm: round numbers without a source.
struct RoundNorm {
  std::string_view metric;
  double novice, expert;
};
constexpr std::array kRound{RoundNorm{"lung_punctures", 0.05, 0.005},
                            RoundNorm{"used_needle_insertions", 0.2, 0.02},
                            RoundNorm{"other_vein_punctures", 0.05, 0.005},
                            RoundNorm{"vein_checks", 0.75, 0.99},
                            RoundNorm{"bone_contacts", 0.2, 0.03},
                            RoundNorm{"redirections", 0.8, 0.2},
                            RoundNorm{"time_to_vein_s", 60, 15},
                            RoundNorm{"attempt_time_s", 300, 120},
                            RoundNorm{"path_deviation_mm", 4, 1.5},
                            RoundNorm{"vein_centre_distance_mm", 4, 1.5},
                            RoundNorm{"nearest_artery_mm", 3, 8},
                            RoundNorm{"nearest_lung_mm", 20, 25},
                            RoundNorm{"probe_translations", 0.9, 0.3},
                            RoundNorm{"probe_rotations", 0.8, 0.2},
                            RoundNorm{"probe_force_mean_N", 3, 2},
                            RoundNorm{"probe_force_max_N", 7, 4}};

struct Course {
  std::vector<MetricMeaning> metrics;  ///< each with the values of novice and expert, if the metric is simulated
  int procedureVersion = 0;
};

Result<Course> courseOf(const std::string& name) {
  const auto procedure = builtInProcedure(name);
  if (!procedure) return tl::unexpected(procedure.error());
  Course course{metricMeanings(*procedure), procedure->version};
  for (MetricMeaning& metric : course.metrics)
    if (const auto round = std::ranges::find(kRound, metric.id, &RoundNorm::metric);
        !metric.expert && round != kRound.end())
      metric.novice = round->novice, metric.expert = round->expert;
  return course;
}

/// Punctures are events with a probability; the skin and the vein are punctured at least once.
std::optional<double> valueOf(const MetricMeaning& metric, double skill, Dice& dice) {
  if (metric.id == "insertion_angle_deg") return 45 + (12 - 7 * skill) * dice.normal();
  if (metric.id == "passes" || metric.id == "vein_punctures") return 1 + dice.happens(0.6 - 0.5 * skill);
  if (!metric.novice) return std::nullopt;
  const double middle = std::max(0.0, *metric.novice + (*metric.expert - *metric.novice) * skill);
  if (metric.unit.empty()) return dice.happens(middle);
  const double value = middle * std::exp(0.25 * dice.normal());
  return metric.unit == "%" && metric.better == MetricMeaning::Better::Higher ? std::min(100.0, value) : value;
}

/// The mean of the metrics' shares; 0 with a critical error, at most 50 without success, as in procedure/AttemptScore.
double pointsOf(const AttemptFacts& facts, const std::vector<MetricMeaning>& metrics) {
  double sum = 0;
  int shares = 0;
  for (std::size_t i = 0; i < metrics.size(); ++i)
    if (const auto share =
            facts.metrics[i].value ? metrics[i].positionBetweenNorms(*facts.metrics[i].value) : std::nullopt)
      sum += *share, ++shares;
  if (facts.criticalErrors > 0 || shares == 0) return 0;
  return std::min(sum / shares, facts.succeeded ? 100.0 : 50.0);
}

AttemptFacts attemptOf(const Course& course, const Level& level, const Curriculum& curriculum, double skill,
                       Dice& dice) {
  AttemptFacts facts;
  facts.curriculum = curriculum.name, facts.curriculumVersion = curriculum.version, facts.level = level.name;
  facts.procedure = level.procedure, facts.procedureVersion = course.procedureVersion;
  facts.caseName = level.caseName;
  for (const MetricMeaning& metric : course.metrics)
    facts.metrics.push_back({metric.id, metric.version, valueOf(metric, skill, dice)});
  const auto value = [&](std::string_view id) {
    return std::ranges::find(facts.metrics, id, &MetricFact::id)->value.value_or(0);
  };
  facts.criticalErrors = static_cast<int>(value("artery_punctures") + value("lung_punctures"));
  facts.succeeded = value("tip_in_vein") > 0 && facts.criticalErrors == 0;
  facts.state = dice.happens(0.06 - 0.05 * skill) ? AttemptState::Abandoned : AttemptState::Completed;
  facts.length_us = static_cast<std::int64_t>(1e6 * value("attempt_time_s"));
  facts.points = pointsOf(facts, course.metrics);
  facts.proof = AttemptProof::Demonstration;
  if (level.assistance == Assistance::Test) facts.testConditions = TestConditions::Opened;
  return facts;
}

/// The first level to learn or to renew; the last one if all are mastered.
const Level& levelNow(const Curriculum& curriculum, const std::vector<AttemptFacts>& history, std::int64_t now_us) {
  for (const LevelProgress& progress : computeProgress(curriculum, history, now_us))
    if (progress.state == LevelState::Open || progress.state == LevelState::Lapsed)
      return *curriculum.level(progress.level);
  return curriculum.levels.back();
}

}  // namespace

Result<std::vector<AttemptFacts>> demoAttempts(const Curriculum& curriculum, int trainee, const DemoClassPlan& plan) {
  std::map<std::string, Course> courses;
  for (const Level& level : curriculum.levels) {
    auto course = courseOf(level.procedure);
    if (!course) return tl::unexpected(course.error());
    courses.insert_or_assign(level.procedure, std::move(*course));
  }
  Dice dice(plan.seed, trainee);
  const Trainee who{dice.between(-0.3, 0.4), dice.between(0.7, 1.2), dice.between(0.2, 0.7)};
  std::vector<AttemptFacts> attempts;
  std::int64_t time_us = kMorning_us;
  const Level* level = nullptr;
  for (int i = 0; i < plan.attempts; ++i) {
    if (i % kSession == 0) {
      time_us += kDay_us * static_cast<int>(dice.between(1, 5));
      level = &levelNow(curriculum, attempts, time_us);
    }
    attempts.push_back(attemptOf(courses.at(level->procedure), *level, curriculum, who.skill(i + 1), dice));
    attempts.back().begun_us = time_us + (i % kSession) * 10 * kMinute_us;
  }
  if (attempts.empty()) return attempts;
  const std::int64_t lastDay = plan.until_us / kDay_us - static_cast<int>(dice.between(1, 10));
  const std::int64_t later_us = (lastDay - attempts.back().begun_us / kDay_us) * kDay_us;
  for (AttemptFacts& facts : attempts) facts.begun_us += later_us;
  return attempts;
}

}  // namespace insonate
