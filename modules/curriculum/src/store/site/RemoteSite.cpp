#include "store/Seals.h"
#include "store/StoredRecordings.h"
#include "store/site/Site.h"
#include "store/site/WireJson.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace insonate::store {
namespace {

using nlohmann::json;

constexpr std::size_t kPart_bytes = 512 << 10;

/// The text of the answer; fails also if the server refuses.
Result<std::string> textOf(const SiteLink& link, const std::string& path, const std::string& body) {
  auto answer = link.send(path, body);
  if (!answer) return tl::unexpected(answer.error());
  if (answer->isRefusal) return fail(std::move(answer->text));
  return std::move(answer->text);
}

/// Asks and reads the answer by `read`, which may throw what the library throws for an unexpected message.
template <class Read>
auto ask(const SiteLink& link, const std::string& path, json content, const Read& read)
    -> Result<decltype(read(std::declval<const json&>()))> {
  const auto answer = textOf(link, path, messageOf(std::move(content)));
  if (!answer) return tl::unexpected(answer.error());
  const auto message = readMessage(*answer);
  if (!message) return tl::unexpected(message.error());
  try {
    return read(*message);
  } catch (const json::exception&) {
    return fail("The answer of " + link.place +
                " cannot be read. Install the same version of Insonate on the server and on this computer.");
  }
}

std::int64_t receivedFrom(const json& answer) {
  return answer.at("received");
}

/// The number of bytes that the server has then.
Result<std::int64_t> sendPart(const SiteLink& link, const std::string& path, std::string_view bytes) {
  const auto answer = textOf(link, path, std::string(bytes));
  if (!answer) return tl::unexpected(answer.error());
  const auto message = readMessage(*answer);
  if (!message) return tl::unexpected(message.error());
  if (!message->contains("received") || !(*message)["received"].is_number_integer())
    return fail("The answer of " + link.place +
                " cannot be read. Install the same version of Insonate on the server and on this computer.");
  return receivedFrom(*message);
}

/// Continues at the place up to which the server has the file.
Result<void> sendFile(const SiteLink& link, const std::string& attempt, const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::error_code error;
  const auto size = static_cast<std::int64_t>(std::filesystem::file_size(file, error));
  if (!in || error) return fail("The recording " + file.string() + " cannot be read; check its permissions.");
  const auto pathAt = [&](std::int64_t offset_bytes) {
    return "recordings/" + attempt + "/" + std::to_string(offset_bytes) + "/" + std::to_string(size);
  };
  auto received = sendPart(link, pathAt(0), {});
  std::string part;
  while (received && *received < size) {
    part.resize(std::min<std::size_t>(kPart_bytes, static_cast<std::size_t>(size - *received)));
    in.clear();
    in.seekg(*received);
    in.read(part.data(), static_cast<std::streamsize>(part.size()));
    if (!in) return fail("The recording " + file.string() + " cannot be read; check its permissions.");
    const auto next = sendPart(link, pathAt(*received), part);
    if (next && *next <= *received)
      return fail(link.place + " did not accept the recording of the attempt " + attempt +
                  "; the recording is sent again later.");
    received = next;
  }
  return received ? Result<void>() : tl::unexpected(received.error());
}

Result<SentPerson> personBy(const SiteLink& link, const std::string& path, const json& content) {
  auto people = ask(link, path, content, [](const json& answer) { return peopleFrom(answer.at("people")); });
  if (!people) return tl::unexpected(people.error());
  if (people->empty()) return fail("The answer of " + link.place + " names no person; try again.");
  return std::move(people->front());
}

}  // namespace

bool RemoteSite::answers() {
  return link_.send("hello", "").has_value();
}

Result<void> RemoteSite::greet(Core& here) {
  const auto secret = inTransaction(
      here, Way::Read, [](Transaction& transaction) -> Result<std::string> { return secretText(transaction); });
  if (!secret) return tl::unexpected(secret.error());
  const auto answer =
      ask(link_, "hello", {{"workstation", here.workstation()}, {"secret", *secret}}, [](const json&) { return true; });
  return answer ? Result<void>() : tl::unexpected(answer.error());
}

Result<std::set<std::string>> RemoteSite::unknownPeople(const std::set<std::string>& ids) {
  return ask(link_, "unknown-people", {{"ids", ids}},
             [](const json& answer) { return answer.at("ids").get<std::set<std::string>>(); });
}

Result<std::vector<std::string>> RemoteSite::addPeople(const std::vector<SentPerson>& people) {
  return ask(link_, "people", {{"people", jsonOf(people)}},
             [](const json& answer) { return answer.at("troubles").get<std::vector<std::string>>(); });
}

Result<Taken> RemoteSite::take(const SentBatch& batch) {
  return ask(link_, "facts", jsonOf(batch), [](const json& answer) { return takenFrom(answer); });
}

Result<Taught> RemoteSite::teach() {
  return ask(link_, "directory", json::object(), [](const json& answer) { return taughtFrom(answer); });
}

Result<AttemptsElsewhere> RemoteSite::attemptsElsewhere(const Digests& known, const std::string& after) {
  return ask(link_, "attempts-elsewhere", {{"digests", known}, {"after", after}},
             [](const json& answer) { return elsewhereFrom(answer); });
}

Result<std::optional<SentPerson>> RemoteSite::signIn(const std::string& name, const std::string& password) {
  auto person = personBy(link_, "sign-in", {{"name", name}, {"password", password}});
  if (!person) return tl::unexpected(person.error());
  return std::make_optional(std::move(*person));
}

Result<SentPerson> RemoteSite::changePassword(const std::string& name, const std::string& old,
                                              const std::string& password) {
  return personBy(link_, "password", {{"name", name}, {"password", old}, {"newPassword", password}});
}

Result<void> RemoteSite::takeRecordings(Core& here, UploadReport& report, const Progress& progress) {
  const auto wanted = ask(link_, "wanted", json::object(),
                          [](const json& answer) { return answer.at("attempts").get<std::vector<std::string>>(); });
  if (!wanted) return tl::unexpected(wanted.error());
  std::vector<std::string> missing;
  // One recording that cannot be sent does not hold up the others; without connection all fail.
  constexpr int kMostFailures = 3;
  int failures = 0;
  for (std::size_t i = 0; i < wanted->size(); ++i) {
    if (!insonate::report(progress, "sending recordings", static_cast<double>(i) / static_cast<double>(wanted->size())))
      return fail(std::string(kCancelled));
    const auto file = storedRecording(here.recordings(), (*wanted)[i]);
    std::error_code ignored;
    if (here.recordings().empty() || !std::filesystem::is_regular_file(file, ignored)) {
      missing.push_back((*wanted)[i]);
      continue;
    }
    const auto sent = sendFile(link_, (*wanted)[i], file);
    if (sent) {
      ++report.recordings;
      continue;
    }
    // A refusal of all recordings is told once.
    if (std::ranges::find(report.errors, sent.error().message) == report.errors.end())
      report.errors.push_back(sent.error().message);
    if (++failures == kMostFailures) break;
  }
  if (missing.empty()) return {};
  const auto told = ask(link_, "unavailable", {{"attempts", missing}}, [](const json&) { return true; });
  return told ? Result<void>() : tl::unexpected(told.error());
}

}  // namespace insonate::store
