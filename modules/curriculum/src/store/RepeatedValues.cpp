#include "store/MetricsText.h"
#include "store/Session.h"

#include <insonate/curriculum/Implausible.h>
#include <insonate/curriculum/RepeatedValues.h>

namespace insonate {

using store::Act;
using store::Actor;
using store::Row;
using store::Transaction;

Result<std::set<std::string>> repeatedValues(const SignedIn& by, const std::string& person) {
  return by.session()->read(
      {.act = Act::SeeAttempts, .person = person, .detail = "values of earlier attempts"},
      [&](Transaction& transaction, const Actor&) -> Result<std::set<std::string>> {
        std::set<std::string> repeated;
        // The same values take the same time (attempt_time_s), by which there is an index.
        for (const Row& row :
             transaction.rows("SELECT id, metrics FROM attempts AS own WHERE person = ? AND state <> 'open' AND EXISTS "
                              "(SELECT 1 FROM attempts AS earlier WHERE earlier.length_us = own.length_us AND "
                              "earlier.metrics = own.metrics AND earlier.arrival < own.arrival)",
                              person))
          if (describesNeedle(store::metricsOf(row.text(1)))) repeated.insert(row.text(0));
        return repeated;
      });
}

}  // namespace insonate
