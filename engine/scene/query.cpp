#include "engine/scene/query.h"

#include <algorithm>

#include "engine/base/clock.h"
#include "engine/scene/sphere.h"

namespace palpate {

void Query::run(const Model& a, const Model& b, const Pose& a_from_b, const QueryOptions& options) {
  const Stopwatch watch;
  contacts_.clear();
  contacts_.work.bodies = 1;
  const Sphere around_a{a.centre(), a.radius()};
  const Sphere around_b = a_from_b * Sphere{b.centre(), b.radius()};
  if (within_reach(around_a, around_b, options.law.cutoff)) search(a, b, a_from_b, options);
  contacts_.search_us = contacts_.work.coherence.global_us = watch.elapsed_us();
}

void Query::search(const Model& a, const Model& b, const Pose& a_from_b, const QueryOptions& options) {
  SearchOptions search_options;
  search_options.cutoff = options.law.cutoff;
  search_options.near_minima = options.force_law == ForceLaw::kSmooth;
  // At least one, because an empty list means that nothing overlaps.
  search_options.max_overlaps = std::max<std::size_t>(options.max_overlaps, 1);
  search_.run(a, b, a_from_b, search_options, found_);

  contacts_.work.body_pairs = 1;
  contacts_.work.search = found_.work;
  const ContactPair pair{a.mesh(), b.mesh(), 0, 0, Pose{}, options.law, options.max_overlaps};
  append_contacts(found_, pair, contacts_);
  springs_.forget();
  springs_.update(law_springs_.of(found_, options.force_law, options.law.cutoff),
                  {a_from_b, options.law.cutoff});
  forces_.clear();
  forces_.add(springs_.list(), pair, options.force_law == ForceLaw::kSmooth ? kNoSet : 0, contacts_);
  forces_.finish(0.0, a_from_b * options.reference_point, contacts_);
}

}  // namespace palpate
