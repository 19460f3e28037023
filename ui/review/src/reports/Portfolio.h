#pragma once

#include "../person/PersonReading.h"

#include <insonate/core/Progress.h>
#include <insonate/curriculum/CommentStore.h>
#include <insonate/curriculum/FormStore.h>

#include <QPageSize>
#include <QPicture>
#include <QSizeF>
#include <QString>
#include <vector>

namespace insonate::review {

/// Contents of a person's portfolio.
struct Portfolio {
  PersonFacts person{};
  std::vector<StoredAttempt> attempts{};  ///< all attempts, in the order in which they were begun
  std::vector<StoredForm> judgements{};   ///< checklists and ratings, in the order of submission
  std::vector<AttemptComment> comments{};
  std::string reader{};  ///< full name of the user who reads the portfolio
};

/// Queries a portfolio on the account's thread; `curriculum` is that of the person's class.
Result<Portfolio> readPortfolio(const SignedIn& by, const std::string& person,
                                const std::optional<Curriculum>& curriculum, std::int64_t now_us);

/// Size of the drawing of one level's curves, in pixels of the screen.
inline constexpr QSizeF kCurves_px{665, 250};
/// Draws the curves of each level that has attempts, as vectors. May be used only on the window's thread, since charts
/// are widgets.
std::vector<QPicture> curvesOf(const Portfolio& portfolio);

/// Text of the portfolio, without the curves.
QString portfolioText(const Portfolio& portfolio);

/// Writes a portfolio as PDF: levels, tests, curves, checklists and ratings, comments, attempts. The text fits both A4
/// and Letter at actual size. The file is first written under another name and then renamed. May be used on any thread.
Result<void> writePortfolio(const QString& file, const Portfolio& portfolio, const std::vector<QPicture>& curves,
                            QPageSize::PageSizeId paper, const Progress& progress);

}  // namespace insonate::review
