#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptFacts.h>

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace insonate {

/// One option of a Choice question of a form.
struct FormOption {
  std::string name{};              ///< name under which the answer is stored
  std::string title{};             ///< text shown to the user
  std::optional<double> points{};  ///< points of the option; empty: not scored, e.g. "not seen"

  bool operator==(const FormOption&) const = default;
};

/// Metric of an attempt that answers a Choice question with points. A value within the limits means the option with
/// the most points, another value the option with the fewest points.
struct FormEvidence {
  std::string metric{};  ///< id of the metric (procedure/AttemptMetrics.h): "vein_checks"
  std::optional<double> least{}, most{};
  /// Direction in which a value decides; in the other direction the question stays without an answer.
  enum class Proof { Both, Done, NotDone };
  Proof proof = Proof::Both;
  std::string after{};  ///< metric that must have a value above 0, e.g. "passes", or there is no answer; or empty

  bool operator==(const FormEvidence&) const = default;
};

/// A question of a form (questionnaire, checklist or rating scale).
struct FormItem {
  enum class Kind { Choice, Number, Text };

  std::string name{};  ///< id of the question, unique within the form
  std::string title{};
  std::string about{};  ///< hint for the rater, or empty
  Kind kind = Kind::Choice;
  bool needed = false;
  /// Options of a Choice question, in the order shown; on a scale the points rise or fall in this order.
  std::vector<FormOption> options{};
  double minimum = 0, maximum = 0;  ///< range of the answer to a Number question
  std::optional<FormEvidence> evidence{};

  bool operator==(const FormItem&) const = default;
};

struct FormSection {
  std::string title{}, about{};
  std::vector<FormItem> items{};

  bool operator==(const FormSection&) const = default;
};

/// A questionnaire, a checklist, a rating scale or a debrief, as data.
struct Form {
  enum class Purpose {
    Questionnaire,  ///< filled in by the trainee, about the simulator
    Checklist,      ///< filled in by a rater, about an attempt: which steps were done
    Rating,         ///< filled in by a rater, about an attempt: how well it was done
    Debrief,        ///< filled in by the trainee and by instructors, about an attempt: what to learn from it
  };

  std::string name{}, title{}, about{};
  std::string source{};  ///< publication on which the form's structure is based
  int version = 1;
  Purpose purpose = Purpose::Questionnaire;
  std::vector<FormSection> sections{};

  const FormItem* item(std::string_view itemName) const;
  /// Tells whether a rater judges an attempt by this form.
  bool isJudgement() const { return purpose == Purpose::Checklist || purpose == Purpose::Rating; }
  /// Tells whether a rater may add a note to the answer. This is allowed in checklists and ratings, except for Text
  /// questions.
  bool acceptsNote(const FormItem& item) const { return isJudgement() && item.kind != FormItem::Kind::Text; }
  bool operator==(const Form&) const = default;
};

/// Returns the names of the built-in forms, which are in resources/forms.
std::vector<std::string> formPresetNames();
/// Loads a built-in form by name, or a JSON file of the same format. Fails with a sentence that names the place and the
/// error.
Result<Form> loadForm(std::string_view nameOrPath);
Result<Form> parseForm(std::string_view json);

/// Answers to a form. Key: FormItem::name for an answer (an option's name, a text or a number), noteKey() for a note (a
/// text). Unanswered questions are missing.
using FormAnswers = std::map<std::string, std::variant<std::string, double>>;

/// Returns the key of FormAnswers under which a rater's note on a question is stored; it differs from all
/// FormItem::name.
std::string noteKey(const FormItem& item);
/// Returns an answer as shown to users: an option's title, a number or a text; "" without an answer.
std::string answerText(const FormItem& item, const FormAnswers& answers);
std::string noteText(const FormItem& item, const FormAnswers& answers);

/// Returns the answers that the metrics of an attempt give (FormItem::evidence), as a proposal for a rater. A metric
/// without a value answers nothing.
FormAnswers answersFrom(const Form& form, const std::vector<MetricFact>& metrics);

/// Reads answers from the JSON object in FilledForm::answers.
Result<FormAnswers> parseAnswers(std::string_view json);
std::string answersText(const FormAnswers& answers);

struct AnswerError {
  /// question concerned (FormItem::name), or key of an answer that belongs to no question of the form
  std::string item{};
  std::string sentence{};  ///< explains the error and what to do
};

/// Returns all errors in answers to a form, in the form's order; empty if the answers can be stored.
std::vector<AnswerError> checkAnswers(const Form& form, const FormAnswers& answers);

/// Score of a filled form.
struct FormScore {
  /// points and maximum points, summed over questions that were answered with an option that has points
  double points = 0, maxPoints = 0;
  std::optional<double> percent{};  ///< 100 points / maxPoints; empty if no question is scored
  int scored = 0;                   ///< number of questions answered with an option that has points
  /// Number of questions that have options with points, but gave no points: they were not answered, or were answered
  /// with an option that has no points.
  int unscored = 0;
};

/// Computes the score of a filled form; invalid answers are left out. FormScore::maxPoints sums the points of each
/// question's best option.
FormScore formScore(const Form& form, const FormAnswers& answers);

}  // namespace insonate
