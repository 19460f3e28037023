#pragma once

#include <insonate/cases/CaseCheck.h>
#include <insonate/cases/PatientCase.h>
#include <insonate/procedure/AttemptMetrics.h>
#include <insonate/procedure/Procedure.h>
#include <insonate/views/Theme.h>

#include <optional>

namespace insonate::ui {

/// Result of a check, for example whether a case is fit for training.
enum class CheckState { Unknown, Passed, Warnings, Failed };
/// State of a step that a guide leads through.
enum class StepState { ToDo, Working, Done, Warning, Skipped };

/// Colors of states. Some users cannot distinguish them: show the symbol or the words of AttemptWords.h beside each.
views::Colour colorOf(NeedlePlace place);
/// Color of a finding's severity; a quiet color if there is no finding.
views::Colour colorOf(const std::optional<Severity>& severity);
views::Colour colorOf(CheckState state);
/// Color of a finding of the check of a case.
views::Colour colorOf(FindingSeverity severity);
/// Color of an author's progress on a structure.
views::Colour colorOf(LabelState state);
views::Colour colorOf(StepState state);

}  // namespace insonate::ui
