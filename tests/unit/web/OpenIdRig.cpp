#include "OpenIdRig.h"

#include "openid/ProviderAddress.h"
#include "openid/SignInTry.h"
#include "page/Page.h"

#include <cjose/header.h>
#include <cjose/jwk.h>
#include <cjose/jws.h>
#include <cjose/util.h>
#include <gtest/gtest.h>

#include <QByteArray>
#include <QUrl>
#include <chrono>

namespace insonate::test {
namespace {

std::int64_t secondsNow() {
  using namespace std::chrono;
  return duration_cast<seconds>(system_clock::now().time_since_epoch()).count();
}

web::Response json(const nlohmann::json& content, int status = 200) {
  return {.status = status, .type = "application/json", .body = content.dump()};
}

std::shared_ptr<cjose_jwk_t> owned(cjose_jwk_t* key) {
  if (!key) throw std::runtime_error("the library made no key");
  return {key, [](cjose_jwk_t* one) { cjose_jwk_release(one); }};
}

cjose_jwk_t* newKey(TestKey::Kind kind) {
  cjose_err error{};
  const std::uint8_t exponent[]{1, 0, 1};
  return kind == TestKey::Kind::Rsa ? cjose_jwk_create_RSA_random(2048, exponent, sizeof exponent, &error)
                                    : cjose_jwk_create_EC_random(CJOSE_JWK_EC_P_256, &error);
}

}  // namespace

std::string base64Url(const std::string& bytes) {
  return QByteArray::fromStdString(bytes)
      .toBase64(QByteArray::Base64UrlEncoding | QByteArray::OmitTrailingEquals)
      .toStdString();
}

TestKey::TestKey(Kind kind, std::string id) : key_(owned(newKey(kind))), id_(std::move(id)) {}

TestKey::TestKey(const std::string& bytes) : id_("hmac") {
  cjose_err error{};
  key_ = owned(cjose_jwk_create_oct_spec(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(), &error));
}

nlohmann::json TestKey::open() const {
  cjose_err error{};
  char* text = cjose_jwk_to_json(key_.get(), false, &error);
  nlohmann::json key = nlohmann::json::parse(text);
  cjose_get_dealloc()(text);
  key["kid"] = id_;
  key["use"] = "sig";
  return key;
}

std::string TestKey::sign(const std::string& algorithm, const std::string& content) const {
  cjose_err error{};
  cjose_header_t* header = cjose_header_new(&error);
  cjose_header_set(header, CJOSE_HDR_ALG, algorithm.c_str(), &error);
  cjose_header_set(header, CJOSE_HDR_KID, id_.c_str(), &error);
  cjose_jws_t* token =
      cjose_jws_sign(key_.get(), header, reinterpret_cast<const std::uint8_t*>(content.data()), content.size(), &error);
  const char* text = nullptr;
  if (!token || !cjose_jws_export(token, &text, &error)) throw std::runtime_error("the library signs nothing");
  std::string made = text;
  cjose_jws_release(token);
  cjose_header_release(header);
  return made;
}

const TestKey& TestKey::rsa() {
  static const TestKey key(Kind::Rsa, "one");
  return key;
}

const TestKey& TestKey::otherRsa() {
  static const TestKey key(Kind::Rsa, "one");
  return key;
}

const TestKey& TestKey::curve() {
  static const TestKey key(Kind::Curve, "two");
  return key;
}

MadeUpProvider::MadeUpProvider(web::WebOptions options) {
  options.port = 0;
  auto started = web::HttpServer::start(options, [this](const web::Request& request) { return answer(request); });
  if (!started) throw std::runtime_error(started.error().message);
  server_ = std::move(*started);
  issuer =
      (options.certificate.empty() ? "http" : "https") + std::string("://127.0.0.1:") + std::to_string(server_->port());
  metadata = {{"issuer", issuer},
              {"authorization_endpoint", issuer + "/authorize"},
              {"token_endpoint", issuer + "/token"},
              {"jwks_uri", issuer + "/keys"}};
  keys = {{"keys", nlohmann::json::array({TestKey::rsa().open(), TestKey::curve().open()})}};
  sign = [](const std::string& content) { return TestKey::rsa().sign("RS256", content); };
}

web::OpenIdOptions MadeUpProvider::options() const {
  return {.issuer = issuer, .clientId = "insonate at work", .secret = "a secret: 1%", .name = "Test Hospital"};
}

std::string MadeUpProvider::signIn(const std::string& address) {
  const std::size_t query = address.find('?');
  if (address.substr(0, query) != metadata["authorization_endpoint"]) throw std::runtime_error("not here: " + address);
  const web::Fields asked = web::fieldsOfForm(address.substr(query + 1));
  EXPECT_EQ(web::valueOf(asked, "response_type"), "code");
  EXPECT_EQ(web::valueOf(asked, "client_id"), options().clientId);
  EXPECT_EQ(web::valueOf(asked, "scope"), "openid email");
  EXPECT_EQ(web::valueOf(asked, "code_challenge_method"), "S256");
  const std::string code = "code " + std::to_string(++lastCode_);
  const std::string& back = web::valueOf(asked, "redirect_uri");
  codes_[code] = {web::valueOf(asked, "nonce"), web::valueOf(asked, "code_challenge"), back};
  const std::string path = back.substr(back.find('/', back.find("://") + 3));
  return web::withQuery(path, {{"code", code}, {"state", web::valueOf(asked, "state")}});
}

web::Response MadeUpProvider::answer(const web::Request& request) {
  if (request.path == "/keys") ++keyRequests;
  if (request.path == "/token") ++tokenRequests;
  if (const auto found = answers.find(request.path); found != answers.end()) return found->second;
  if (request.path == "/.well-known/openid-configuration") return json(metadata);
  if (request.path == "/keys") return json(keys);
  if (request.path == "/token" && request.method == "POST") return token(request);
  return {.status = 404};
}

bool MadeUpProvider::knowsClient(const web::Request& request) const {
  const web::OpenIdOptions client = options();
  if (metadata.contains("token_endpoint_auth_methods_supported"))
    return web::valueOf(request.form, "client_id") == client.clientId &&
           web::valueOf(request.form, "client_secret") == client.secret;
  const std::string both = web::encoded(client.clientId) + ":" + web::encoded(client.secret);
  return web::valueOf(request.headers, "authorization") ==
         "Basic " + QByteArray::fromStdString(both).toBase64().toStdString();
}

web::Response MadeUpProvider::token(const web::Request& request) {
  if (!knowsClient(request)) return json({{"error", "invalid_client"}}, 401);
  const auto found = codes_.find(web::valueOf(request.form, "code"));
  if (found == codes_.end() || web::valueOf(request.form, "redirect_uri") != found->second.returnAddress ||
      web::challengeOf(web::valueOf(request.form, "code_verifier")) != found->second.challenge)
    return json({{"error", "invalid_grant"}}, 400);
  nlohmann::json content{{"iss", issuer},
                         {"aud", options().clientId},
                         {"sub", "12"},
                         {"exp", secondsNow() + 300},
                         {"iat", secondsNow()},
                         {"nonce", found->second.nonce},
                         {"email", "anna@example.org"},
                         {"email_verified", true}};
  codes_.erase(found);
  content.merge_patch(claims);
  return json({{"id_token", sign(content.dump())}, {"access_token", "x"}, {"token_type", "Bearer"}});
}

web::Response TestBrowser::ask(web::Request request) {
  request.client = address_;
  request.headers["host"] = "insonate.example";
  request.cookies.insert(cookies.begin(), cookies.end());
  web::Response response = site_->answer(request);
  for (const auto& [name, value] : response.headers) {
    if (name != "Set-Cookie") continue;
    const std::size_t equals = value.find('=');
    const std::string cookie = value.substr(0, equals),
                      content = value.substr(equals + 1, value.find(';') - equals - 1);
    if (content.empty())
      cookies.erase(cookie);
    else
      cookies[cookie] = content;
  }
  return response;
}

web::Response TestBrowser::get(const std::string& path) {
  return ask(WebSchool::request("GET", path, ""));
}

web::Response TestBrowser::post(const std::string& path, web::Fields form) {
  web::Request request = WebSchool::request("POST", path, "");
  request.headers["sec-fetch-site"] = "same-origin";
  if (const auto secret = cookies.find("insonate"); secret != cookies.end())
    form.emplace("code", web::formCode(secret->second));
  request.form = std::move(form);
  return ask(std::move(request));
}

std::string TestBrowser::atProvider(MadeUpProvider& provider, const std::string& next) {
  const web::Response sent = get(web::withQuery("/sign-in/openid", {{"next", next}}));
  if (sent.status != 303) throw std::runtime_error("not sent to the provider: " + sent.body);
  return provider.signIn(headerOf(sent, "Location"));
}

}  // namespace insonate::test
