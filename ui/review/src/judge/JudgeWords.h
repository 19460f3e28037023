#pragma once

#include <insonate/curriculum/FormAgreement.h>

#include <QString>
#include <optional>

namespace insonate::review {

/// Formats a coefficient: "0.62", "n/a".
QString coefficientOf(const std::optional<double>& value);
/// Formats a coefficient with its interval, if there is one: "0.62 (0.10 to 0.85)".
QString coefficientOf(const std::optional<Estimate>& value);
/// Formats a share: "95 %", "n/a".
QString percentOf(const std::optional<double>& share);
/// Describes the agreement of two raters: "Dr Ina and Dr Otto: 95 % of 22 answers alike, kappa 0.62, ICC of the scores
/// n/a".
QString displayText(const RaterPair& pair);
/// Formats a score: "86 % (19 of 22 points)"; "n/a" if no item is scored.
QString scoreWords(const FormScore& score);

}  // namespace insonate::review
