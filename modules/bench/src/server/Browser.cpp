#include "server/Browser.h"

#include <curl/curl.h>

#include <chrono>
#include <functional>
#include <random>
#include <string>
#include <utility>

namespace insonate::bench {
namespace {

constexpr long kConnect_s = 5, kLongest_s = 60;

std::string addressOf(int number) {
  constexpr int kPerNet = 250;
  return "127.1." + std::to_string(number / kPerNet) + "." + std::to_string(number % kPerNet + 1);
}

std::size_t append(char* bytes, std::size_t size, std::size_t count, void* into) {
  static_cast<std::string*>(into)->append(bytes, size * count);
  return size * count;
}

/// A stream that is being read.
struct Stream {
  using Clock = std::chrono::steady_clock;

  const std::function<void()>& changed;
  const std::atomic<bool>& isOver;
  std::mt19937 random;
  std::string text{};
  bool isDue = false;
  Clock::time_point due{}, told{};

  void note() {
    if (!std::exchange(isDue, true)) due = Clock::now() + delay();
  }
  /// Pages ask after a delay of their own, so that a change does not make all of them ask at once.
  std::chrono::milliseconds delay() {
    constexpr int kLongest_ms = 2000;
    return std::chrono::milliseconds(std::uniform_int_distribution(0, kLongest_ms)(random));
  }
  void tell() {
    constexpr std::chrono::seconds kShortestPause(5);
    if (!isDue || Clock::now() < due || Clock::now() - told < kShortestPause) return;
    isDue = false, told = Clock::now();
    changed();
  }
  static std::size_t take(char* bytes, std::size_t size, std::size_t count, void* self) {
    auto& stream = *static_cast<Stream*>(self);
    stream.text.append(bytes, size * count);
    // An empty line ends an event.
    for (std::size_t end = stream.text.find("\n\n"); end != std::string::npos; end = stream.text.find("\n\n")) {
      if (stream.text.substr(0, end).find("event: changed") != std::string::npos) stream.note();
      stream.text.erase(0, end + 2);
    }
    stream.tell();
    return size * count;
  }
  /// Is called about every second while nothing arrives.
  static int check(void* self, curl_off_t /*down*/, curl_off_t /*downNow*/, curl_off_t /*up*/, curl_off_t /*upNow*/) {
    auto& stream = *static_cast<Stream*>(self);
    if (stream.isOver) return 1;
    stream.tell();
    return 0;
  }
};

std::string encodedForm(CURL* curl, const std::map<std::string, std::string>& form) {
  std::string text;
  for (const auto& [name, value] : form) {
    char* encoded = curl_easy_escape(curl, value.c_str(), static_cast<int>(value.size()));
    text += (text.empty() ? "" : "&") + name + "=" + (encoded ? encoded : "");
    curl_free(encoded);
  }
  return text;
}

void prepare(CURL* curl, const std::string& url, const std::string& client) {
  curl_easy_reset(curl);  // cookies and connections stay
  curl_easy_setopt(curl, CURLOPT_URL, url.c_str());
  curl_easy_setopt(curl, CURLOPT_INTERFACE, ("host!" + client).c_str());
  curl_easy_setopt(curl, CURLOPT_COOKIEFILE, "");
  curl_easy_setopt(curl, CURLOPT_NOSIGNAL, 1L);
  curl_easy_setopt(curl, CURLOPT_CONNECTTIMEOUT, kConnect_s);
  curl_easy_setopt(curl, CURLOPT_PROXY, "");
}

int statusOf(CURL* curl) {
  long status = 0;
  curl_easy_getinfo(curl, CURLINFO_RESPONSE_CODE, &status);
  return static_cast<int>(status);
}

}  // namespace

Browser::Browser(std::string url, int number)
    : url_(std::move(url)), client_(addressOf(number)), curl_(curl_easy_init()), stream_(curl_easy_init()) {}

Browser::~Browser() {
  curl_easy_cleanup(stream_);
  curl_easy_cleanup(curl_);
}

Result<Answer> Browser::perform(const std::string& path) {
  Answer answer;
  curl_easy_setopt(curl_, CURLOPT_WRITEFUNCTION, &append);
  curl_easy_setopt(curl_, CURLOPT_WRITEDATA, &answer.body);
  curl_easy_setopt(curl_, CURLOPT_TIMEOUT, kLongest_s);
  const auto begun = std::chrono::steady_clock::now();
  const CURLcode code = curl_easy_perform(curl_);
  answer.time_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
  if (code != CURLE_OK) return fail(url_ + path + ": " + curl_easy_strerror(code) + ".");
  answer.status = statusOf(curl_);
  return answer;
}

Result<Answer> Browser::get(const std::string& path) {
  prepare(curl_, url_ + path, client_);
  return perform(path);
}

Result<Answer> Browser::refresh(const std::string& path) {
  prepare(curl_, url_ + path, client_);
  curl_slist* headers = curl_slist_append(nullptr, "Insonate-Refresh: 1");
  curl_easy_setopt(curl_, CURLOPT_HTTPHEADER, headers);
  auto answer = perform(path);
  curl_slist_free_all(headers);
  return answer;
}

Result<Answer> Browser::post(const std::string& path, const std::map<std::string, std::string>& form) {
  prepare(curl_, url_ + path, client_);
  const std::string body = encodedForm(curl_, form);
  curl_easy_setopt(curl_, CURLOPT_POSTFIELDSIZE_LARGE, static_cast<curl_off_t>(body.size()));
  curl_easy_setopt(curl_, CURLOPT_POSTFIELDS, body.c_str());
  return perform(path);
}

Result<void> Browser::signIn(const std::string& name, const std::string& password) {
  constexpr int kSeeOther = 303;
  const auto answer = post("/sign-in", {{"name", name}, {"password", password}, {"next", "/"}});
  if (!answer) return tl::unexpected(answer.error());
  if (answer->status != kSeeOther)
    return fail("The server refuses to sign " + name + " in: status " + std::to_string(answer->status) + ".");
  return {};
}

int Browser::follow(const std::string& path, const std::function<void()>& changed, const std::atomic<bool>& isOver) {
  curl_slist* cookies = nullptr;
  curl_easy_getinfo(curl_, CURLINFO_COOKIELIST, &cookies);
  prepare(stream_, url_ + path, client_);
  for (const curl_slist* one = cookies; one; one = one->next) curl_easy_setopt(stream_, CURLOPT_COOKIELIST, one->data);
  curl_slist_free_all(cookies);
  Stream stream{.changed = changed, .isOver = isOver, .random = std::mt19937(std::hash<std::string>()(client_))};
  curl_easy_setopt(stream_, CURLOPT_WRITEFUNCTION, &Stream::take);
  curl_easy_setopt(stream_, CURLOPT_WRITEDATA, &stream);
  curl_easy_setopt(stream_, CURLOPT_NOPROGRESS, 0L);
  curl_easy_setopt(stream_, CURLOPT_XFERINFOFUNCTION, &Stream::check);
  curl_easy_setopt(stream_, CURLOPT_XFERINFODATA, &stream);
  return curl_easy_perform(stream_) == CURLE_OK ? statusOf(stream_) : 0;
}

}  // namespace insonate::bench
