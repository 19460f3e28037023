#include "Commands.h"

#include <insonate/camera/HandsSheet.h>

#include <nlohmann/json.hpp>

#include <iostream>
#include <memory>

namespace insonate::cli {
namespace {

struct PrintOptions {
  std::string file, paper = "a4";
  bool json = false;
};

Result<void> printSheet(const PrintOptions& options) {
  const auto pages = handsSheet(options.paper == "letter" ? PaperSize::kLetter : PaperSize::kA4);
  if (!pages) return tl::unexpected(pages.error());
  if (auto ok = writeHandsSheet(*pages, options.file); !ok) return ok;
  if (options.json)
    printJson({{"file", options.file}, {"pages", pages->size()}, {"paper", options.paper}});
  else
    std::cout << "Wrote " << pages->size() << " pages to " << options.file
              << ". Print them at 100 % (actual size), and check the ruler on each page.\n";
  return {};
}

}  // namespace

void addHandsCommand(CLI::App& app, Outcome& outcome) {
  auto* hands = app.add_subcommand("hands", "Printed bodies that a camera follows as probe and needle");
  hands->require_subcommand(1);
  auto* print = hands->add_subcommand("print", "Write the sheets to print as a PDF file");
  auto o = std::make_shared<PrintOptions>();
  print->add_option("FILE", o->file, "PDF file to write")->required()->check(notEmpty());
  print->add_option("--paper", o->paper, "Size of the paper: a4 or letter")
      ->capture_default_str()
      ->check(CLI::IsMember({"a4", "letter"}));
  print->add_flag("--json", o->json, "Print one JSON object");
  print->callback([o, &outcome] {
    outcome.json = o->json;
    if (auto done = printSheet(*o); !done) refuse(outcome, done.error());
  });
}

}  // namespace insonate::cli
