#include "OpenIdRig.h"
#include "openid/OpenIdProvider.h"
#include "openid/ProviderAddress.h"

#include <insonate/web/WebServer.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>

namespace insonate::test {
namespace {

using ::testing::HasSubstr;
using namespace std::chrono_literals;

const std::string kReturn = "https://insonate.example/sign-in/openid/return";
constexpr const char* kConfiguration = "/.well-known/openid-configuration";

std::string refusalOf(const web::OpenIdOptions& options, const web::FetchLimits& limits = {}) {
  return test::refusalOf(
      web::OpenIdProvider(options, limits).signInAddress(valueOf(web::beginTry("/me", 1000)), kReturn));
}

TEST(WebOpenIdProvider, AConfigurationThatCannotBeUsedIsTold) {
  MadeUpProvider provider;
  const nlohmann::json metadata = provider.metadata;
  const auto refusalWith = [&](const char* name, const nlohmann::json& value) {
    provider.metadata = metadata;
    provider.metadata[name] = value;
    return refusalOf(provider.options());
  };
  EXPECT_THAT(refusalWith("issuer", "https://elsewhere.example"), HasSubstr("is named https://elsewhere.example, not"));
  EXPECT_THAT(refusalWith("issuer", provider.issuer + "/"), HasSubstr("Set openid-issuer to the name"));
  for (const char* name : {"authorization_endpoint", "token_endpoint", "jwks_uri"})
    for (const nlohmann::json& value : {nlohmann::json("http://elsewhere.example/x"), nlohmann::json(),
                                        nlohmann::json(1), nlohmann::json("file:///etc/passwd")})
      EXPECT_THAT(refusalWith(name, value), HasSubstr("without https://")) << name << value;
  EXPECT_THAT(refusalWith("token_endpoint_auth_methods_supported", {"private_key_jwt"}),
              HasSubstr("takes no client secret"));
}

TEST(WebOpenIdProvider, AnswersThatAreNotTheConfigurationAreTold) {
  MadeUpProvider provider;
  const auto refusalAfter = [&](web::Response answer) {
    provider.answers[kConfiguration] = std::move(answer);
    return refusalOf(provider.options());
  };
  EXPECT_THAT(refusalAfter({.body = "<html>"}), HasSubstr("is no JSON"));
  EXPECT_THAT(refusalAfter({.body = std::string(300 << 10, ' ')}), HasSubstr("has more than 262144 bytes"));
  EXPECT_THAT(refusalAfter({.status = 500}), HasSubstr("status 500"));
  web::Response moved{.status = 302, .headers = {{"Location", "/configuration"}}};
  provider.answers["/configuration"] = {.body = provider.metadata.dump()};
  EXPECT_THAT(refusalAfter(moved), HasSubstr("status 302")) << "is not followed";
}

TEST(WebOpenIdProvider, ThatCannotBeReachedOrIsSlowIsTold) {
  auto provider = std::make_unique<MadeUpProvider>();
  const web::OpenIdOptions options = provider->options();
  std::atomic<bool> isReleased = false;
  const auto slow = web::HttpServer::start({.port = 0}, [&](const web::Request&) {
    while (!isReleased) std::this_thread::sleep_for(1ms);
    return web::Response{};
  });
  ASSERT_TRUE(slow);
  web::OpenIdOptions slowOptions = options;
  slowOptions.issuer = "http://127.0.0.1:" + std::to_string((*slow)->port());
  EXPECT_THAT(refusalOf(slowOptions, {.total = 300ms}), HasSubstr("cannot be reached (Timeout"));
  isReleased = true;
  provider.reset();
  web::OpenIdProvider down(options);
  const auto tried = valueOf(web::beginTry("/me", 1000));
  EXPECT_THAT(test::refusalOf(down.signInAddress(tried, kReturn)), HasSubstr("cannot be reached"));
  EXPECT_THAT(test::refusalOf(down.redeem("1", tried, kReturn, 1000)), HasSubstr("cannot be reached"));
  EXPECT_EQ(down.signOutAddress(), "");
}

TEST(WebOpenIdProvider, KeepsItsMetadataWhileItCannotBeRead) {
  MadeUpProvider provider;
  web::OpenIdProvider kept(provider.options(), {}, 0ms);
  const auto tried = valueOf(web::beginTry("/me", 1000));
  const std::string address = valueOf(kept.signInAddress(tried, kReturn));
  provider.answers[kConfiguration] = {.status = 500};
  EXPECT_EQ(valueOf(kept.signInAddress(tried, kReturn)), address);
  provider.answers.clear();
  provider.metadata["authorization_endpoint"] = provider.issuer + "/other";
  EXPECT_EQ(valueOf(kept.signInAddress(tried, kReturn)), address) << "is asked again after ten seconds";
}

TEST(WebOpenIdProvider, TakesTheSecretInTheFormIfItWantsThat) {
  const StoreRig rig;
  MadeUpProvider provider;
  provider.metadata["token_endpoint_auth_methods_supported"] = {"client_secret_post"};
  const WebSchool school(rig.open());
  web::WebOptions options;
  options.openId = provider.options();
  const web::Site site(rig.open(), options);
  EXPECT_EQ(TestBrowser(site).signIn(provider).status, 303);
}

TEST(WebOpenIdProvider, MustHaveACertificateThatIsTrusted) {
  const TemporaryFolder folder;
  const auto certificate = folder / "certificate.pem", key = folder / "key.pem";
  const std::string command =
      "openssl req -x509 -newkey rsa:2048 -nodes -days 2 -subj /CN=127.0.0.1 -addext subjectAltName=IP:127.0.0.1 "
      "-keyout '" +
      key.string() + "' -out '" + certificate.string() + "' 2>/dev/null";
  if (std::system(command.c_str()) != 0) GTEST_SKIP() << "openssl is not installed";
  MadeUpProvider provider({.certificate = certificate, .key = key});
  web::OpenIdOptions options = provider.options();
  ASSERT_THAT(options.issuer, testing::StartsWith("https://"));
  EXPECT_THAT(refusalOf(options), HasSubstr("openid-authority"));
  options.authority = key;
  EXPECT_THAT(refusalOf(options), HasSubstr("contains no certificate"));
  options.authority = certificate;
  EXPECT_EQ(refusalOf(options), "(it was allowed)");
}

TEST(WebOpenIdOptions, FaultsHaveASentence) {
  const web::OpenIdOptions right{
      .issuer = "https://id.example.org/a", .clientId = "insonate", .secret = "secret", .name = "Hospital"};
  const auto refusalFor = [](const web::OpenIdOptions& options) {
    const auto checked = web::checkOptions({.openId = options});
    return checked ? std::string() : checked.error().message;
  };
  EXPECT_EQ(refusalFor(right), "");
  EXPECT_EQ(refusalFor({}), "");
  for (auto field : {&web::OpenIdOptions::issuer, &web::OpenIdOptions::clientId, &web::OpenIdOptions::secret,
                     &web::OpenIdOptions::name}) {
    web::OpenIdOptions incomplete = right;
    (incomplete.*field).clear();
    EXPECT_THAT(refusalFor(incomplete), HasSubstr("openid-client, openid-secret-file and openid-name"));
  }
  web::OpenIdOptions options = right;
  for (const std::string issuer :
       {"http://id.example.org", "http://127.0.0.1.example.org", "http://localhost.example.org", "id.example.org",
        "ftp://127.0.0.1", "http://127.0.0.1@id.example.org", "https://", "https://user@id.example.org"}) {
    options.issuer = issuer;
    EXPECT_THAT(refusalFor(options), HasSubstr("is not an https:// address")) << issuer;
  }
  for (const std::string issuer : {"http://127.0.0.1:8080/a", "http://localhost:8080", "http://[::1]/a"}) {
    options.issuer = issuer;
    EXPECT_EQ(refusalFor(options), "") << issuer;
  }
  options.issuer = "https://id.example.org/?a=b";
  EXPECT_THAT(refusalFor(options), HasSubstr("has a query"));
  options = right;
  options.authority = "/nowhere.pem";
  EXPECT_THAT(refusalFor(options), HasSubstr("/nowhere.pem cannot be read"));
}

}  // namespace
}  // namespace insonate::test
