#include "capi/src/handles.h"
#include "capi/src/law.h"
#include "capi/src/numbers.h"
#include "capi/src/structs.h"

namespace palpate::capi {
namespace {

QueryOptions checked_query_options(const plp_query_options* given) {
  const plp_query_options options = read_struct(given, "options");
  QueryOptions checked_options;
  checked_options.law.cutoff = checked_positive(options.cutoff, "options->cutoff");
  checked_options.law.stiffness = checked_not_negative(options.stiffness, "options->stiffness");
  checked_options.force_law = law_of(options.law, "options->law");
  checked_options.max_overlaps = options.max_overlaps;
  checked_options.reference_point = checked(vector_of(options.reference_point), "options->reference_point");
  return checked_options;
}

}  // namespace
}  // namespace palpate::capi

using namespace palpate;
using namespace palpate::capi;

void plp_contacts_init(plp_contacts* contacts, size_t size) {
  fill_struct(plp_contacts{}, contacts, size);
}

plp_result plp_query_result_create(plp_query_result* result) {
  return guarded([&] {
    require(result, "result is null");
    *result = new_handle<plp_query_result>(query_table(), std::make_unique<QueryObject>());
  });
}

plp_result plp_query_result_release(plp_query_result result) {
  return guarded([&] { release_handle(query_table(), result, "result"); });
}

void plp_query_options_init(plp_query_options* options, size_t size) {
  plp_query_options filled{};
  filled.max_overlaps = 1024;
  filled.stiffness = 1000.0;
  fill_struct(filled, options, size);
}

plp_result plp_query(plp_model a, plp_model b, const plp_pose* a_from_b, const plp_query_options* options,
                     plp_query_result result) {
  return guarded([&] {
    const auto object = query_table().pin(bits_of(result));
    require_handle(object, "result");
    object->arrays.clear();
    const auto model_a = model_table().pin(bits_of(a));
    require_handle(model_a, "a");
    const auto model_b = model_table().pin(bits_of(b));
    require_handle(model_b, "b");
    require(a_from_b, "a_from_b is null");
    const Pose pose = Space().pose_in(*a_from_b, "a_from_b");
    const QueryOptions checked_options = checked_query_options(options);

    object->query.run(*model_a->model, *model_b->model, pose, checked_options);
    object->arrays.assign(object->query.contacts(), Space());
  });
}

plp_result plp_query_result_get(plp_query_result result, plp_contacts* contacts) {
  return guarded([&] {
    const auto object = query_table().pin(bits_of(result));
    require_handle(object, "result");
    write_struct(object->arrays.shown(), contacts, "contacts");
  });
}
