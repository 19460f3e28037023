#include "openid/Fetch.h"

#include "openid/ProviderAddress.h"

#include <curl/curl.h>

#include <memory>

namespace insonate::web {
namespace {

struct CurlCloser {
  void operator()(CURL* curl) const { curl_easy_cleanup(curl); }
};

struct AnswerTaker {
  std::string body{};
  std::size_t max_bytes = 0;
  bool isTooLarge = false;
};

std::size_t takeAnswer(char* bytes, std::size_t size, std::size_t count, void* into) {
  auto& taker = *static_cast<AnswerTaker*>(into);
  taker.isTooLarge = taker.body.size() + size * count > taker.max_bytes;
  if (taker.isTooLarge) return 0;
  taker.body.append(bytes, size * count);
  return size * count;
}

void setUp(CURL* curl, const FetchRequest& request, const FetchLimits& limits) {
  curl_easy_setopt(curl, CURLOPT_URL, request.url.c_str());
  curl_easy_setopt(curl, CURLOPT_PROTOCOLS_STR, isOnLoopback(request.url) ? "http,https" : "https");
  // A proxy of the environment does not reach this computer.
  if (isOnLoopback(request.url)) curl_easy_setopt(curl, CURLOPT_NOPROXY, "*");
  curl_easy_setopt(curl, CURLOPT_FOLLOWLOCATION, 0L);
  curl_easy_setopt(curl, CURLOPT_NOSIGNAL, 1L);
  curl_easy_setopt(curl, CURLOPT_CONNECTTIMEOUT_MS, static_cast<long>(limits.connection.count()));
  curl_easy_setopt(curl, CURLOPT_TIMEOUT_MS, static_cast<long>(limits.total.count()));
  if (!request.form.empty()) {
    curl_easy_setopt(curl, CURLOPT_POSTFIELDSIZE_LARGE, static_cast<curl_off_t>(request.form.size()));
    curl_easy_setopt(curl, CURLOPT_COPYPOSTFIELDS, request.form.data());
  }
  if (!request.user.empty()) {
    curl_easy_setopt(curl, CURLOPT_HTTPAUTH, static_cast<long>(CURLAUTH_BASIC));
    curl_easy_setopt(curl, CURLOPT_USERNAME, request.user.c_str());
    curl_easy_setopt(curl, CURLOPT_PASSWORD, request.password.c_str());
  }
  if (!request.authority.empty()) curl_easy_setopt(curl, CURLOPT_CAINFO, request.authority.c_str());
}

std::string sentenceFor(CURLcode code, const std::string& url) {
  if (code == CURLE_PEER_FAILED_VERIFICATION)
    return "The certificate of " + url +
           " is not valid for this name, or was signed by an authority that this computer does not trust. Name the "
           "authority's certificate with openid-authority.";
  if (code == CURLE_SSL_CACERT_BADFILE)
    return "The file that openid-authority names contains no certificate. Name a file in PEM.";
  return url + " cannot be reached (" + curl_easy_strerror(code) + "). Check the address and the network.";
}

}  // namespace

Result<Fetched> fetch(const FetchRequest& request, const FetchLimits& limits) {
  static const CURLcode initialized = curl_global_init(CURL_GLOBAL_DEFAULT);
  if (initialized != CURLE_OK) return fail("The library for HTTPS does not start. Reinstall libcurl.");
  if (!isProtected(request.url)) return fail("The provider names an address without https://: " + request.url);
  const std::unique_ptr<CURL, CurlCloser> curl(curl_easy_init());
  if (!curl) return fail("There is no memory for a connection to " + request.url + ". Close another program.");
  AnswerTaker taker{.max_bytes = limits.answer_bytes};
  setUp(curl.get(), request, limits);
  curl_easy_setopt(curl.get(), CURLOPT_WRITEFUNCTION, &takeAnswer);
  curl_easy_setopt(curl.get(), CURLOPT_WRITEDATA, &taker);
  const CURLcode code = curl_easy_perform(curl.get());
  if (taker.isTooLarge)
    return fail("The answer of " + request.url + " has more than " + std::to_string(limits.answer_bytes) +
                " bytes. Check that this is the address of an identity provider.");
  if (code != CURLE_OK) return fail(sentenceFor(code, request.url));
  Fetched fetched{.body = std::move(taker.body)};
  curl_easy_getinfo(curl.get(), CURLINFO_RESPONSE_CODE, &fetched.status);
  return fetched;
}

}  // namespace insonate::web
