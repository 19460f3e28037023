#include "Answer.h"
#include "Groups.h"

#include <insonate/curriculum/SiteUpload.h>

#include <iostream>
#include <memory>

namespace insonate::cli {
namespace {

Result<Answer> upload(const StoreOptions& options, const std::string& address) {
  const auto here = openOrMakeStore(options);  // a new workstation begins with what the server has
  if (!here) return tl::unexpected(here.error());
  const auto server = openStore({.database = address, .name = {}, .passwordFile = {}});
  if (!server) return tl::unexpected(server.error());
  const SiteUpload site(*here, *server);
  const auto report = site.exchange(terminalProgress());
  if (!report) return tl::unexpected(report.error());
  const auto pending = site.pending();
  if (!pending) return tl::unexpected(pending.error());
  for (const std::string& trouble : report->troubles) std::cerr << trouble << '\n';
  return Answer{{{"server", server->place()},
                 {"attempts", report->attempts},
                 {"forms", report->forms},
                 {"people", report->people},
                 {"classes", report->cohorts},
                 {"curricula", report->curricula},
                 {"pending", *pending},
                 {"troubles", report->troubles}},
                server->place() + " took " + std::to_string(report->attempts) + " attempts and " +
                    std::to_string(report->forms) + " forms, and gave " + std::to_string(report->people) + " people, " +
                    std::to_string(report->cohorts) + " classes and " + std::to_string(report->curricula) +
                    " curricula; " + std::to_string(*pending) + " wait."};
}

}  // namespace

void addUploadCommand(CLI::App& curriculum, Outcome& outcome) {
  auto server = std::make_shared<std::string>();
  addStoreCommand(curriculum, outcome, "upload",
                  "Attempts and forms go up to a server, people, classes and curricula come down", SigningIn::No,
                  [server](const StoreOptions& options) { return upload(options, *server); })
      ->add_option("SERVER", *server, "postgresql://USER@HOST/DATABASE; the password from PGPASSWORD or ~/.pgpass")
      ->required()
      ->check(notEmpty());
}

}  // namespace insonate::cli
