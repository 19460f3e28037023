#include <insonate/core/AtomicFile.h>
#include <insonate/curriculum/AttemptTable.h>
#include <insonate/curriculum/Judgement.h>
#include <insonate/curriculum/XapiStatements.h>

#include <nlohmann/json.hpp>

#include <QDateTime>
#include <QString>
#include <QUuid>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <map>

namespace insonate {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kAdl = "http://adlnet.gov/expapi/verbs/";

std::string text(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Encodes a part of an address (RFC 3986, 2.1); characters in `plainToo` stay, too.
std::string encoded(const std::string& part, std::string_view plainToo = "") {
  constexpr std::string_view kPlain = "-._~";
  std::string text;
  for (const unsigned char c : part) {
    char escape[4];
    std::snprintf(escape, sizeof escape, "%%%02X", c);
    const bool plain = (c < 0x80 && std::isalnum(c)) || kPlain.find(static_cast<char>(c)) != std::string_view::npos ||
                       plainToo.find(static_cast<char>(c)) != std::string_view::npos;
    text += plain ? std::string(1, static_cast<char>(c)) : escape;
  }
  return text;
}

Result<std::string> homeOf(const XapiSite& site) {
  std::string home = site.homePage;
  while (home.ends_with('/')) home.pop_back();
  // RFC 3987, 2.2
  const auto isOdd = [](unsigned char c) {
    return c <= ' ' || c == 0x7f ||
           std::string_view("\"<>\\^`{|}").find(static_cast<char>(c)) != std::string_view::npos;
  };
  const std::size_t host = home.starts_with("https://") ? 8 : home.starts_with("http://") ? 7 : 0;
  if (host == 0 || home.size() == host || std::any_of(home.begin(), home.end(), isOdd))
    return fail("'" + site.homePage +
                "' is not a home page for xAPI statements. Give the address of your site, for example "
                "https://training.example.org.");
  return home;
}

Json verb(const std::string& id, const char* word) {
  return {{"id", id}, {"display", {{"en", word}}}};
}

/// Writes the statements of one person at one site.
class Writer {
 public:
  Writer(std::string home, bool byMail, const Curriculum& curriculum, const Person& person)
      : home_(std::move(home)), byMail_(byMail), curriculum_(curriculum), person_(person) {}

  std::string of(const AttemptFacts& attempt, const Level* level) const {
    if (attempt.state == AttemptState::Voided) return voiding(attempt);
    Json statement{{"id", idOf(attempt.id)}, {"actor", actor()}, {"verb", verbOf(attempt, level)}};
    statement["object"] = level ? levelActivity(*level) : practiceActivity(attempt);
    statement["result"] = resultOf(attempt, level);
    statement["context"] = contextOf(attempt, level);
    if (const std::string time = timeOf(attempt); !time.empty()) statement["timestamp"] = time;
    statement["version"] = "1.0.0";
    return text(statement);
  }

 private:
  /// RFC 4122, 4.3: the same name in the same namespace gives the same id.
  std::string idOf(const std::string& name) const {
    static const QUuid kAddresses("6ba7b811-9dad-11d1-80b4-00c04fd430c8");
    const QUuid here = QUuid::createUuidV5(kAddresses, QString::fromStdString(home_));
    return QUuid::createUuidV5(here, QString::fromStdString(name)).toString(QUuid::WithoutBraces).toStdString();
  }

  Json actor() const {
    Json agent{{"objectType", "Agent"}};
    if (!person_.fullName.empty()) agent["name"] = person_.fullName;
    if (byMail_ && !person_.email.empty())
      agent["mbox"] = "mailto:" + encoded(person_.email, "@+!$'*,");  // RFC 6068, 2
    else
      agent["account"] = {{"homePage", home_}, {"name", person_.id}};
    return agent;
  }

  Json voiding(const AttemptFacts& attempt) const {
    const Json object{{"objectType", "StatementRef"}, {"id", idOf(attempt.id)}};
    return text({{"id", idOf("void " + attempt.id)},
                 {"actor", {{"objectType", "Agent"}, {"account", {{"homePage", home_}, {"name", "insonate"}}}}},
                 {"verb", verb(std::string(kAdl) + "voided", "voided")},
                 {"object", object},
                 {"version", "1.0.0"}});
  }

  static Json verbOf(const AttemptFacts& attempt, const Level* level) {
    if (attempt.state == AttemptState::Abandoned) return verb("https://w3id.org/xapi/adl/verbs/abandoned", "abandoned");
    if (!level) return verb(std::string(kAdl) + "completed", "completed");
    const char* word = judge(level->pass, attempt).passed ? "passed" : "failed";
    return verb(std::string(kAdl) + word, word);
  }

  static Json activity(const std::string& id, const char* type, const std::string& name, const std::string& about) {
    Json definition{{"type", "http://adlnet.gov/expapi/activities/" + std::string(type)}, {"name", {{"en", name}}}};
    if (!about.empty()) definition["description"] = {{"en", about}};
    return {{"objectType", "Activity"}, {"id", id}, {"definition", std::move(definition)}};
  }

  std::string curriculumId() const {
    return home_ + "/curricula/" + encoded(curriculum_.name) + "/" + std::to_string(curriculum_.version);
  }

  Json levelActivity(const Level& level) const {
    Json made = activity(curriculumId() + "/" + encoded(level.name), "simulation", level.title, level.about);
    made["definition"]["extensions"] = {{home_ + "/assistance", nameOf(level.assistance)}};
    return made;
  }

  Json practiceActivity(const AttemptFacts& attempt) const {
    return activity(home_ + "/practice/" + encoded(attempt.procedure), "simulation",
                    "Free practice: " + attempt.procedure, "");
  }

  Json resultOf(const AttemptFacts& attempt, const Level* level) const {
    Json result{{"success", level ? judge(level->pass, attempt).passed : isSuccess(attempt)},
                {"completion", attempt.state == AttemptState::Completed}};
    if (const auto points = pointsOf(attempt); points && *points >= 0 && *points <= 100)
      result["score"] = {{"scaled", *points / 100}, {"raw", *points}, {"min", 0}, {"max", 100}};
    if (attempt.length_us >= 0) result["duration"] = durationOf(attempt.length_us);
    Json extensions{{home_ + "/criticalErrors", attempt.criticalErrors}};
    for (const MetricFact& metric : attempt.metrics)
      if (metric.value && std::isfinite(*metric.value))
        extensions[home_ + "/metrics/" + encoded(metric.id) + "/" + std::to_string(metric.version)] = *metric.value;
    result["extensions"] = std::move(extensions);
    return result;
  }

  Json contextOf(const AttemptFacts& attempt, const Level* level) const {
    Json context{{"platform", "Insonate"}, {"language", "en"}};
    if (level) {
      Json whole = activity(curriculumId(), "course", curriculum_.title, curriculum_.about);
      context["contextActivities"] = {{"grouping", Json::array({std::move(whole)})}};
    }
    context["extensions"] = {{home_ + "/case", attempt.caseName},
                             {home_ + "/procedure", attempt.procedure},
                             {home_ + "/procedureVersion", attempt.procedureVersion}};
    if (level && level->assistance == Assistance::Test)
      context["extensions"][home_ + "/sitting"] = nameOf(attempt.testConditions);
    return context;
  }

  /// ISO 8601 in hundredths of a second, as the standard asks.
  static std::string durationOf(std::int64_t length_us) {
    const long long hundredths = length_us / 10'000;
    char duration[48];
    std::snprintf(duration, sizeof duration, "PT%lld.%02lldS", hundredths / 100, hundredths % 100);
    return duration;
  }

  /// Time at which an attempt ended; empty outside the years that ISO 8601 writes with four digits.
  static std::string timeOf(const AttemptFacts& attempt) {
    const std::int64_t end_ms = attempt.begun_us / 1000 + std::max<std::int64_t>(attempt.length_us, 0) / 1000;
    const QDateTime time = QDateTime::fromMSecsSinceEpoch(end_ms, Qt::UTC);
    const int year = time.date().year();
    return year >= 1 && year <= 9999 ? time.toString(Qt::ISODateWithMs).toStdString() : "";
  }

  std::string home_;
  bool byMail_;
  const Curriculum& curriculum_;
  const Person& person_;
};

/// Reason why an attempt has no statement; empty if it has one.
std::string whyLeftOut(const Curriculum& curriculum, const AttemptFacts& attempt) {
  if (attempt.state == AttemptState::Open) return "not ended";
  if (attempt.state != AttemptState::Voided && !isCounted(attempt)) return "abandoned before the skin was punctured";
  if (attempt.curriculum.empty()) return {};
  if (attempt.curriculum != curriculum.name) return "of the curriculum '" + attempt.curriculum + "'";
  if (attempt.curriculumVersion != curriculum.version)
    return "of version " + std::to_string(attempt.curriculumVersion) + " of the curriculum";
  const Level* level = curriculum.level(attempt.level);
  if (!level) return "of the level '" + attempt.level + "', which the curriculum lacks";
  if (attempt.state == AttemptState::Voided || isCounted(attempt, *level)) return {};
  if (countsAsPractice(attempt, *level)) return "practice, since no test was open";
  if (attempt.proof == AttemptProof::Verifying) return "being verified by the server, so its pass does not count yet";
  return "not proven, so its pass does not count until an instructor accepts it";
}

}  // namespace

Result<XapiExport> xapiStatements(const XapiSite& site, const Curriculum& curriculum, const Person& person,
                                  std::span<const AttemptFacts> attempts) {
  auto home = homeOf(site);
  if (!home) return tl::unexpected(home.error());
  const Writer writer(std::move(*home), site.byMail, curriculum, person);
  XapiExport written;
  for (const AttemptFacts& attempt : attempts) {
    if (attempt.person != person.id) continue;
    if (const std::string why = whyLeftOut(curriculum, attempt); !why.empty()) {
      written.leftOut.push_back({attempt.id, why});
      continue;
    }
    const Level* level = attempt.curriculum.empty() ? nullptr : curriculum.level(attempt.level);
    written.statements.push_back(writer.of(attempt, level));
  }
  return written;
}

std::string leftOutSentence(std::span<const LeftOutAttempt> leftOut) {
  if (leftOut.empty()) return {};
  std::map<std::string, int> reasons;
  for (const LeftOutAttempt& one : leftOut) ++reasons[one.why];
  std::string sentence =
      "Left out: " + std::to_string(leftOut.size()) + (leftOut.size() == 1 ? " attempt" : " attempts");
  for (const auto& [why, count] : reasons)
    sentence += (sentence.find('(') == std::string::npos ? " (" : "; ") + std::to_string(count) + " " + why;
  return sentence + ").";
}

std::string xapiText(std::span<const std::string> statements) {
  std::string text = "[";
  for (std::size_t i = 0; i < statements.size(); ++i) text += (i ? ",\n" : "\n") + statements[i];
  return text + "\n]\n";
}

Result<void> writeXapi(const std::filesystem::path& file, std::span<const std::string> statements) {
  return writeAtomically(file, xapiText(statements));
}

}  // namespace insonate
