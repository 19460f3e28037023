#include "Answer.h"
#include "Groups.h"
#include "Password.h"

#include <insonate/curriculum/SiteUpload.h>
#include <insonate/site/CaseDownload.h>
#include <insonate/site/HttpLink.h>

#include <iostream>
#include <memory>
#include <optional>
#include <vector>

namespace insonate::cli {
namespace {

struct UploadArguments {
  std::string server, tokenFile, authority;
  std::string cases;    ///< folder for the server's cases; empty: none are downloaded
  StoreOptions person;  ///< who signs in to the server at this computer
};

/// Connection to insonate-server; without a value for a database.
Result<std::optional<SiteLink>> linkTo(const UploadArguments& a) {
  if (!isHttpAddress(a.server)) {
    if (!a.cases.empty()) return fail("--cases needs the https address of insonate-server: a database has no cases.");
    return std::nullopt;
  }
  const auto token = readPassword({a.tokenFile, "INSONATE_TOKEN", "Token of this computer"});
  if (!token) return tl::unexpected(token.error());
  auto link = httpLink({.url = a.server, .token = *token, .authority = a.authority});
  return link ? Result<std::optional<SiteLink>>(std::move(*link)) : tl::unexpected(link.error());
}

Result<SiteUpload> siteOf(const CurriculumStore& here, const UploadArguments& a, const std::optional<SiteLink>& link) {
  if (link) return SiteUpload(here, *link);
  const auto server = openStore({.database = a.server, .name = {}, .passwordFile = {}});
  return server ? Result<SiteUpload>(SiteUpload(here, *server)) : tl::unexpected(server.error());
}

/// Downloads the cases that the classes of this computer need. A failure is one of the troubles, since attempts were
/// sent before.
CaseDownloadReport casesOf(const SiteUpload& site, const SiteLink& link, const std::string& folder) {
  const auto names = site.caseNames();
  if (!names) return {.errors = {names.error().message}};
  auto done = downloadCases(link, *names, folder, terminalProgress());
  return done ? std::move(*done) : CaseDownloadReport{.errors = {done.error().message}};
}

Result<Answer> upload(const StoreOptions& options, const UploadArguments& a) {
  const auto here = openOrMakeStore(options);  // a new workstation begins with what the server has
  if (!here) return tl::unexpected(here.error());
  const auto link = linkTo(a);
  if (!link) return tl::unexpected(link.error());
  const auto site = siteOf(*here, a, *link);
  if (!site) return tl::unexpected(site.error());
  if (!a.person.name.empty()) {
    const auto password = readOwnPassword(a.person);
    if (!password) return tl::unexpected(password.error());
    if (const auto reached = site->signIn(a.person.name, *password); !reached) return tl::unexpected(reached.error());
  }
  const auto report = site->exchange(terminalProgress());
  if (!report) return tl::unexpected(report.error());
  const auto pending = site->pending();
  if (!pending) return tl::unexpected(pending.error());
  const CaseDownloadReport cases = *link && !a.cases.empty() ? casesOf(*site, **link, a.cases) : CaseDownloadReport();
  std::vector<std::string> troubles = report->errors;
  troubles.insert(troubles.end(), cases.errors.begin(), cases.errors.end());
  for (const std::string& trouble : troubles) std::cerr << trouble << '\n';
  return Answer{
      {{"server", site->place()},
       {"attempts", report->attempts},
       {"forms", report->forms},
       {"recordings", report->recordings},
       {"people", report->people},
       {"classes", report->cohorts},
       {"curricula", report->curricula},
       {"cases", cases.titles},
       {"pending", *pending},
       {"troubles", troubles}},
      site->place() + " took " + std::to_string(report->attempts) + " attempts, " + std::to_string(report->recordings) +
          " recordings and " + std::to_string(report->forms) + " forms, and gave " + std::to_string(report->people) +
          " people, " + std::to_string(report->cohorts) + " classes, " + std::to_string(report->curricula) +
          " curricula and " + std::to_string(cases.titles.size()) + " cases; " + std::to_string(*pending) + " wait."};
}

}  // namespace

void addUploadCommand(CLI::App& curriculum, Outcome& outcome) {
  auto a = std::make_shared<UploadArguments>();
  CLI::App* command = addStoreCommand(curriculum, outcome, "upload",
                                      "Send attempts and forms to a server, and receive people, classes and curricula",
                                      SigningIn::No, [a](const StoreOptions& options) { return upload(options, *a); });
  command
      ->add_option("SERVER", a->server,
                   "https://HOST of insonate-server; or postgresql://USER@HOST/DATABASE, with the password from "
                   "PGPASSWORD or ~/.pgpass")
      ->required()
      ->check(notEmpty());
  command
      ->add_option("--token-file", a->tokenFile,
                   "File whose first line is this computer's token for insonate-server, from 'workstations add'; by "
                   "default the environment variable INSONATE_TOKEN, or else the command asks for it")
      ->check(notEmpty());
  command
      ->add_option("--authority", a->authority,
                   "File (PEM) with the certificate of the authority that signed the server's certificate, if the "
                   "system does not know this authority")
      ->check(CLI::ExistingFile);
  command
      ->add_option("--cases", a->cases,
                   "Folder for the published cases that the classes of this computer need; they are downloaded from "
                   "insonate-server")
      ->check(notEmpty());
  command->add_option(
      "--as", a->person.name,
      "Name of a person who signs in to insonate-server at this computer, and can use this computer from then on");
  command->add_option("--password-file", a->person.passwordFile,
                      "File whose first line is this person's password; by default INSONATE_PASSWORD, or else the "
                      "command asks for it");
}

}  // namespace insonate::cli
