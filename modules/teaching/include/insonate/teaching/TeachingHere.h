#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/MetricMeaning.h>
#include <insonate/procedure/Procedure.h>

#include <vector>

namespace insonate {

/// Returns the names to which a curriculum can refer in this installation: built-in cases, the cases with these titles,
/// built-in procedures and all metrics.
Result<TeachingNames> teachingNames(const std::vector<std::string>& caseTitles = {});

/// Returns the properties of all metrics, in the order of metricTable(), without published values of novices and
/// experts.
std::vector<MetricMeaning> metricMeanings();
/// Returns the properties of all metrics, with the procedure's published values of novices and experts.
std::vector<MetricMeaning> metricMeanings(const Procedure& procedure);

}  // namespace insonate
