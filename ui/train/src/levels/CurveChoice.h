#pragma once

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/MetricMeaning.h>

#include <QString>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace insonate::train {

/// Attempts of a learning curve: those of a level, or all of a procedure.
struct CurveChoice {
  QString title{};
  std::string procedure{};
  std::string level{};  ///< "": all of the procedure
};

/// Procedures that were practiced, each with all its attempts and then with its levels, in the curriculum's order.
/// Where nothing was practiced, the first level's procedure.
std::vector<CurveChoice> curveChoices(const Curriculum* curriculum, std::span<const AttemptFacts> history);

/// The points, then all metrics, with the norms of a procedure; of none that is known, without.
std::vector<MetricMeaning> curveMetrics(const std::string& procedure);

/// One value for each attempt that counts, in their order.
std::vector<std::optional<double>> curveValues(const Curriculum* curriculum, std::span<const AttemptFacts> history,
                                               const CurveChoice& which, const MetricMeaning& meaning);

}  // namespace insonate::train
