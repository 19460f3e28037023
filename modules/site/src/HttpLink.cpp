#include <insonate/site/HttpLink.h>

#include <arpa/inet.h>
#include <curl/curl.h>

#include <memory>
#include <mutex>
#include <string_view>

namespace insonate {
namespace {

constexpr long kConnect_s = 10, kStill_s = 30, kLongest_s = 600, kStill_bytesPerS = 1;
constexpr std::size_t kLargestAnswer_bytes = std::size_t{256} << 20;
constexpr long kOk = 200, kUnauthorized = 401, kUnprocessable = 422;

std::string hostOf(std::string_view url) {
  url.remove_prefix(std::min(url.size(), url.find("://") + 3));
  if (url.starts_with('[')) return std::string(url.substr(1, url.find(']') - 1));
  return std::string(url.substr(0, url.find_first_of(":/")));
}

/// Addresses only, since a name such as 127.example.org can be that of any computer.
bool isLoopback(const std::string& host) {
  in_addr address{};
  const bool isAddress = ::inet_pton(AF_INET, host.c_str(), &address) == 1;
  return host == "localhost" || host == "::1" || (isAddress && host.starts_with("127."));
}

std::size_t append(char* bytes, std::size_t size, std::size_t count, void* into) {
  auto& text = *static_cast<std::string*>(into);
  if (text.size() + size * count > kLargestAnswer_bytes) return 0;
  text.append(bytes, size * count);
  return size * count;
}

/// One connection, which is kept open between requests.
class HttpConnection {
 public:
  explicit HttpConnection(SiteAddress address) : address_(std::move(address)), curl_(curl_easy_init()) {
    headers_ = curl_slist_append(headers_, ("Authorization: Bearer " + address_.token).c_str());
    headers_ = curl_slist_append(headers_, "Content-Type: application/octet-stream");
    // Without this, large bodies wait a second for a permission that few servers give.
    headers_ = curl_slist_append(headers_, "Expect:");
  }
  ~HttpConnection() {
    curl_slist_free_all(headers_);
    curl_easy_cleanup(curl_);
  }
  HttpConnection(const HttpConnection&) = delete;
  HttpConnection& operator=(const HttpConnection&) = delete;

  Result<SiteAnswer> ask(const std::string& path, const std::string& body) {
    const std::lock_guard lock(mutex_);
    if (!curl_) return fail("There is no memory for a connection. Close another program and try again.");
    std::string answer;
    const std::string url = address_.url + "/api/site/" + path;
    curl_easy_reset(curl_);
    curl_easy_setopt(curl_, CURLOPT_URL, url.c_str());
    curl_easy_setopt(curl_, CURLOPT_PROTOCOLS_STR, "http,https");
    curl_easy_setopt(curl_, CURLOPT_HTTPHEADER, headers_);
    curl_easy_setopt(curl_, CURLOPT_POSTFIELDS, body.data());
    curl_easy_setopt(curl_, CURLOPT_POSTFIELDSIZE_LARGE, static_cast<curl_off_t>(body.size()));
    curl_easy_setopt(curl_, CURLOPT_WRITEFUNCTION, &append);
    curl_easy_setopt(curl_, CURLOPT_WRITEDATA, &answer);
    curl_easy_setopt(curl_, CURLOPT_NOSIGNAL, 1L);
    curl_easy_setopt(curl_, CURLOPT_CONNECTTIMEOUT, kConnect_s);
    curl_easy_setopt(curl_, CURLOPT_LOW_SPEED_LIMIT, kStill_bytesPerS);
    curl_easy_setopt(curl_, CURLOPT_LOW_SPEED_TIME, kStill_s);
    curl_easy_setopt(curl_, CURLOPT_TIMEOUT, kLongest_s);
    const std::string authority = address_.authority.string();
    if (!authority.empty()) curl_easy_setopt(curl_, CURLOPT_CAINFO, authority.c_str());
    const CURLcode code = curl_easy_perform(curl_);
    if (code != CURLE_OK) return fail(findingText(code));
    long status = 0;
    curl_easy_getinfo(curl_, CURLINFO_RESPONSE_CODE, &status);
    if (status == kOk) return SiteAnswer{false, std::move(answer)};
    if (status == kUnauthorized)
      return SiteAnswer{true,
                        "The server does not accept this computer's token: the token was revoked or mistyped. Ask an "
                        "administrator for a new token."};
    if (status == kUnprocessable) return SiteAnswer{true, std::move(answer)};
    return fail(address_.url + " answered with status " + std::to_string(status) +
                ". Check that the address is that of Insonate's server; if it is, try again in a minute.");
  }

 private:
  std::string findingText(CURLcode code) const {
    if (code == CURLE_PEER_FAILED_VERIFICATION)
      return "The certificate of " + address_.url +
             " is not valid for this name, or was signed by an authority that this computer does not trust. Ask the "
             "server's administrator for the certificate file of the authority.";
    if (code == CURLE_SSL_CACERT_BADFILE)
      return "The authority's certificate " + address_.authority.string() + " cannot be read. Name a file in PEM.";
    return address_.url + " cannot be reached (" + curl_easy_strerror(code) + "). Check the address and the network.";
  }

  const SiteAddress address_;
  std::mutex mutex_;
  CURL* curl_;
  curl_slist* headers_ = nullptr;
};

}  // namespace

bool isHttpAddress(const std::string& address) {
  return address.starts_with("https://") || address.starts_with("http://");
}

Result<SiteLink> httpLink(const SiteAddress& address) {
  static const CURLcode initialized = curl_global_init(CURL_GLOBAL_DEFAULT);
  if (initialized != CURLE_OK) return fail("The library for HTTPS does not start. Reinstall libcurl.");
  SiteAddress kept = address;
  while (kept.url.ends_with('/')) kept.url.pop_back();
  if (!isHttpAddress(kept.url) || hostOf(kept.url).empty())
    return fail("'" + address.url + "' is no address of a server; it begins with https://.");
  if (kept.url.starts_with("http://") && !isLoopback(hostOf(kept.url)))
    return fail(kept.url + " would send passwords unencrypted over the network. Use https://.");
  if (kept.token.empty() || kept.token.find_first_not_of("0123456789abcdef") != std::string::npos)
    return fail(
        "The token has characters other than 0-9 and a-f. Copy the token as the server's administrator received it.");
  SiteLink link{.place = kept.url, .send = {}};
  link.send = [connection = std::make_shared<HttpConnection>(std::move(kept))](
                  const std::string& path, const std::string& body) { return connection->ask(path, body); };
  return link;
}

}  // namespace insonate
