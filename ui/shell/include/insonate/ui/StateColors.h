#pragma once

#include <insonate/procedure/AttemptMetrics.h>
#include <insonate/procedure/Procedure.h>
#include <insonate/views/Theme.h>

#include <optional>

namespace insonate::ui {

/// Result of a check, for example whether a case is fit for training.
enum class CheckState { Unknown, Passed, Warnings, Failed };

/// Colors of states. Some users cannot distinguish them: show the symbol or the words of AttemptWords.h beside each.
views::Colour colorOf(NeedlePlace place);
/// Color of a finding's severity; a quiet color if there is no finding.
views::Colour colorOf(const std::optional<Severity>& severity);
views::Colour colorOf(CheckState state);

}  // namespace insonate::ui
