#include "store/site/WireJson.h"

#include "store/MetricsText.h"
#include "store/Names.h"
#include "store/OpeningRows.h"
#include "store/Proofs.h"

#include <limits>
#include <utility>

namespace insonate::store {
namespace {

using nlohmann::json;

template <class T>
json orNull(const std::optional<T>& value) {
  return value ? json(*value) : json(nullptr);
}

template <class T>
std::optional<T> optionalFrom(const json& value) {
  return value.is_null() ? std::nullopt : std::optional(value.get<T>());
}

/// Throws for anything but a whole number; the library would convert a fraction.
std::int64_t numberFrom(const json& value) {
  return value.get_ref<const json::number_integer_t&>();
}

/// -1 for a number that is too large, which the checks refuse.
int countFrom(const json& value) {
  const std::int64_t number = numberFrom(value);
  return number >= 0 && number <= std::numeric_limits<int>::max() ? static_cast<int>(number) : -1;
}

json jsonOf(const Row& row) {
  json values = json::array();
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (row.isNull(i))
      values.push_back(nullptr);
    else if (row.value(i).type() == QVariant::String)
      values.push_back(row.text(i));
    else
      values.push_back(row.number(i));
  }
  return values;
}

Row rowFrom(const json& values, std::size_t size) {
  std::vector<QVariant> row;
  for (std::size_t i = 0; i < size; ++i) {
    const json& value = values.at(i);
    if (value.is_null())
      row.emplace_back();
    else if (value.is_string())
      row.push_back(bound(value.get<std::string>()));
    else
      row.push_back(bound(numberFrom(value)));
  }
  return Row(std::move(row));
}

/// Tells whether arrays and objects are nested more deeply than in any message; code that follows them may be
/// recursive.
bool isDeep(const std::string& text) {
  constexpr int kDeepest = 32;
  int depth = 0;
  bool isText = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (isText && c == '\\')
      ++i;
    else if (c == '"')
      isText = !isText;
    else if (!isText && (c == '[' || c == '{') && ++depth > kDeepest)
      return true;
    else if (!isText && (c == ']' || c == '}'))
      --depth;
  }
  return false;
}

json jsonOf(const std::vector<Row>& rows) {
  json list = json::array();
  for (const Row& row : rows) list.push_back(jsonOf(row));
  return list;
}

std::vector<Row> rowsFrom(const json& list, std::size_t size) {
  std::vector<Row> rows;
  for (const json& row : list) rows.push_back(rowFrom(row, size));
  return rows;
}

/// The array that metricsText() writes.
std::vector<MetricFact> metricsFrom(const json& list) {
  std::vector<MetricFact> metrics;
  for (const json& one : list) metrics.push_back({one.at(0), countFrom(one.at(1)), optionalFrom<double>(one.at(2))});
  return metrics;
}

json jsonOf(const AttemptFacts& facts) {
  return {{"id", facts.id},
          {"person", facts.person},
          {"curriculum", facts.curriculum},
          {"curriculumVersion", facts.curriculumVersion},
          {"level", facts.level},
          {"procedure", facts.procedure},
          {"procedureVersion", facts.procedureVersion},
          {"case", facts.caseName},
          {"caseHash", facts.caseHash},
          {"workstation", facts.workstation},
          {"begun_us", facts.begun_us},
          {"length_us", facts.length_us},
          {"state", nameOf(facts.state)},
          {"succeeded", facts.succeeded},
          {"criticalErrors", facts.criticalErrors},
          {"points", orNull(facts.points)},
          {"metrics", json::parse(metricsText(facts.metrics))},
          {"recording", facts.recording},
          {"recordingHash", facts.recordingHash},
          {"handsHash", facts.handsHash},
          {"proof", nameOf(facts.proof)},
          {"sitting", nameOf(facts.testConditions)}};
}

AttemptFacts factsFrom(const json& from) {
  return {.id = from.at("id"),
          .person = from.at("person"),
          .curriculum = from.at("curriculum"),
          .curriculumVersion = countFrom(from.at("curriculumVersion")),
          .level = from.at("level"),
          .procedure = from.at("procedure"),
          .procedureVersion = countFrom(from.at("procedureVersion")),
          .caseName = from.at("case"),
          .caseHash = from.at("caseHash"),
          .workstation = from.at("workstation"),
          .begun_us = numberFrom(from.at("begun_us")),
          .length_us = numberFrom(from.at("length_us")),
          .state = stateNamed(from.at("state").get<std::string>()),
          .succeeded = from.at("succeeded"),
          .criticalErrors = countFrom(from.at("criticalErrors")),
          .points = optionalFrom<double>(from.at("points")),
          .metrics = metricsFrom(from.at("metrics")),
          .recording = from.at("recording"),
          .recordingHash = from.at("recordingHash"),
          .handsHash = from.at("handsHash"),
          .proof = proofNamed(from.at("proof").get<std::string>()),
          .testConditions = sittingNamed(from.at("sitting").get<std::string>())};
}

json jsonOf(const SentAttempt& sent) {
  return {{"facts", jsonOf(sent.ended)},         {"crashed", sent.kept.crashed}, {"voidReason", sent.kept.voidReason},
          {"voided_us", orNull(sent.voided_us)}, {"voidedBy", sent.voidedBy},    {"acceptedBy", sent.acceptedBy},
          {"comments", jsonOf(sent.comments)}};
}

constexpr std::size_t kCommentColumns = 9, kOpeningColumns = 11;

SentAttempt attemptFrom(const json& from) {
  SentAttempt sent{.kept = {.crashed = from.at("crashed"), .voidReason = from.at("voidReason")},
                   .ended = factsFrom(from.at("facts")),
                   .voided_us = optionalFrom<std::int64_t>(from.at("voided_us")),
                   .voidedBy = from.at("voidedBy"),
                   .acceptedBy = from.at("acceptedBy"),
                   .comments = rowsFrom(from.at("comments"), kCommentColumns)};
  sent.kept.facts = sent.ended;
  if (sent.voided_us) sent.kept.facts.state = AttemptState::Voided;
  return sent;
}

json jsonOf(const FilledForm& form) {
  return {{"id", form.id},           {"form", form.form}, {"formVersion", form.formVersion}, {"person", form.person},
          {"attempt", form.attempt}, {"by", form.by},     {"filled_us", form.filled_us},     {"answers", form.answers}};
}

FilledForm formFrom(const json& from) {
  return {.id = from.at("id"),
          .form = from.at("form"),
          .formVersion = countFrom(from.at("formVersion")),
          .person = from.at("person"),
          .attempt = from.at("attempt"),
          .by = from.at("by"),
          .filled_us = numberFrom(from.at("filled_us")),
          .answers = from.at("answers")};
}

/// Without a password, which a workstation does not send.
json jsonOf(const SentItem& item) {
  return {{"number", item.number},
          {"kind", item.kind},
          {"id", item.id},
          {"attempt", item.attempt ? jsonOf(*item.attempt) : json(nullptr)},
          {"form", item.form ? jsonOf(*item.form) : json(nullptr)}};
}

SentItem itemFrom(const json& from) {
  SentItem item{.number = numberFrom(from.at("number")), .kind = from.at("kind"), .id = from.at("id")};
  if (!from.at("attempt").is_null()) item.attempt = attemptFrom(from.at("attempt"));
  if (!from.at("form").is_null()) item.form = formFrom(from.at("form"));
  return item;
}

}  // namespace

json jsonOf(const std::vector<SentPerson>& people) {
  json list = json::array();
  for (const SentPerson& sent : people)
    list.push_back({{"id", sent.person.id},
                    {"name", sent.person.name},
                    {"fullName", sent.person.fullName},
                    {"email", sent.person.email},
                    {"password", sent.password},
                    {"mustChange", sent.mustChange},
                    {"version", sent.version}});
  return list;
}

std::vector<SentPerson> peopleFrom(const json& list) {
  std::vector<SentPerson> people;
  for (const json& from : list) {
    SentPerson& sent = people.emplace_back();
    from.at("id").get_to(sent.person.id);
    from.at("name").get_to(sent.person.name);
    from.at("fullName").get_to(sent.person.fullName);
    from.at("email").get_to(sent.person.email);
    from.at("password").get_to(sent.password);
    from.at("mustChange").get_to(sent.mustChange);
    sent.version = numberFrom(from.at("version"));
  }
  return people;
}

json jsonOf(const SentBatch& batch) {
  json items = json::array();
  for (const SentItem& item : batch.items) items.push_back(jsonOf(item));
  return {{"items", std::move(items)}, {"logEnd", batch.auditEnd.number}, {"logHash", batch.auditEnd.hash}};
}

SentBatch batchFrom(const json& from) {
  SentBatch batch{.auditEnd = {.number = numberFrom(from.at("logEnd")), .hash = from.at("logHash")}};
  for (const json& item : from.at("items")) batch.items.push_back(itemFrom(item));
  return batch;
}

json jsonOf(const Taken& taken) {
  return {
      {"numbers", taken.numbers}, {"attempts", taken.attempts}, {"forms", taken.forms}, {"troubles", taken.troubles}};
}

Taken takenFrom(const json& from) {
  return {.numbers = from.at("numbers"),
          .attempts = from.at("attempts"),
          .forms = from.at("forms"),
          .troubles = from.at("troubles")};
}

json jsonOf(const Taught& taught) {
  json curricula = json::array();
  for (const StoredCurriculum& kept : taught.curricula)
    curricula.push_back({{"name", kept.entry.name},
                         {"version", kept.entry.version},
                         {"hash", kept.entry.hash},
                         {"published_us", kept.entry.published_us},
                         {"publishedBy", kept.entry.publishedBy},
                         {"text", kept.text}});
  return {{"people", taught.people},
          {"classes", taught.cohorts},
          {"members", taught.memberships},
          {"curricula", std::move(curricula)},
          {"voided", jsonOf(taught.voided)},
          {"accepted", jsonOf(taught.accepted)},
          {"refused", jsonOf(taught.refused)},
          {"comments", jsonOf(taught.comments)},
          {"openings", jsonOf(taught.openings)},
          {"erased", taught.erased},
          {"deleted_us", orNull(taught.deleted_us)}};
}

Taught taughtFrom(const json& from) {
  Taught taught{.people = from.at("people").get<Rows>(),
                .cohorts = from.at("classes").get<Rows>(),
                .memberships = from.at("members").get<Rows>(),
                .voided = rowsFrom(from.at("voided"), 4),
                .accepted = rowsFrom(from.at("accepted"), 2),
                .refused = rowsFrom(from.at("refused"), 2),
                .comments = rowsFrom(from.at("comments"), kCommentColumns),
                .openings = rowsFrom(from.at("openings"), kOpeningColumns)};
  for (const json& kept : from.at("curricula"))
    taught.curricula.push_back({{.name = kept.at("name"),
                                 .version = countFrom(kept.at("version")),
                                 .hash = kept.at("hash"),
                                 .published_us = numberFrom(kept.at("published_us")),
                                 .publishedBy = kept.at("publishedBy")},
                                kept.at("text")});
  from.at("erased").get_to(taught.erased);
  taught.deleted_us = optionalFrom<std::int64_t>(from.at("deleted_us"));
  return taught;
}

json jsonOf(const AttemptsElsewhere& part) {
  json attempts = json::array();
  for (const SentAttempt& sent : part.attempts) attempts.push_back(jsonOf(sent));
  return {{"attempts", std::move(attempts)}, {"last", part.last}};
}

AttemptsElsewhere elsewhereFrom(const json& from) {
  AttemptsElsewhere part{.last = from.at("last")};
  for (const json& sent : from.at("attempts")) part.attempts.push_back(attemptFrom(sent));
  return part;
}

std::string messageOf(json content) {
  content["version"] = kWireVersion;
  return content.dump(-1, ' ', false, json::error_handler_t::replace);
}

Result<json> readMessage(const std::string& text) {
  if (isDeep(text)) return fail("The message is nested too deeply to be a message of Insonate.");
  json message = json::parse(text, nullptr, false);
  if (!message.is_object() || !message.contains("version"))
    return fail("The message is not a message of Insonate. Check the address of the server.");
  if (message["version"] != kWireVersion)
    return fail("The message is of another version of Insonate. Install the same version on workstation and server.");
  return message;
}

}  // namespace insonate::store
