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
/// State of a step of a guide.
enum class StepState { ToDo, Working, Done, Warning, Skipped };

/// Returns the color of a place of the needle. Since some users cannot distinguish colors, also show a symbol or words
/// wherever one of these colors is used (AttemptWords.h).
views::Color colorOf(NeedlePlace place);
/// Returns the color of the severity of a finding; a neutral color if there is no finding.
views::Color colorOf(const std::optional<Severity>& severity);
views::Color colorOf(CheckState state);
/// Returns the color of a finding of checkCase().
views::Color colorOf(FindingSeverity severity);
/// Returns the color of an author's progress in labeling a structure.
views::Color colorOf(LabelState state);
views::Color colorOf(StepState state);

}  // namespace insonate::ui
