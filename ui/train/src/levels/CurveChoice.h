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

/// Attempts that a learning curve shows: the attempts at a level, or all attempts at a procedure.
struct CurveChoice {
  QString title{};
  std::string procedure{};
  std::string level{};  ///< name of the level; "": all attempts of the procedure
};

/// Returns the choices for each practiced procedure: all attempts of the procedure, then each of its levels in the
/// curriculum's order. If no procedure was practiced, returns the choices for the first level's procedure.
std::vector<CurveChoice> curveChoices(const Curriculum* curriculum, std::span<const AttemptFacts> history);

/// Returns the meanings of the points and then of all metrics, with the procedure's norms if it is known.
std::vector<MetricMeaning> curveMetrics(const std::string& procedure);

/// Returns one value for each attempt that counts, in the attempts' order; an entry is empty if the value is missing.
std::vector<std::optional<double>> curveValues(const Curriculum* curriculum, std::span<const AttemptFacts> history,
                                               const CurveChoice& which, const MetricMeaning& meaning);

}  // namespace insonate::train
