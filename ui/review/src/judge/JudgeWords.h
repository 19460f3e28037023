#pragma once

#include <insonate/curriculum/FormAgreement.h>

#include <QString>
#include <optional>

namespace insonate::review {

/// "0.62", "n/a".
QString coefficientOf(const std::optional<double>& value);
/// "0.62 (0.10 to 0.85)", without an interval if there is none.
QString coefficientOf(const std::optional<Estimate>& value);
/// "95 %", "n/a", of a share.
QString percentOf(const std::optional<double>& share);
/// "Dr Ina and Dr Otto: 95 % of 22 answers alike, kappa 0.62, ICC of the scores n/a"
QString wordsOf(const RaterPair& pair);
/// "86 % (19 of 22 points)", "n/a" where nothing is scored.
QString scoreWords(const FormScore& score);

}  // namespace insonate::review
