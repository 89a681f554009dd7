/* consumer A B PX PY PZ CUTOFF: prints the contacts of B, moved by P, with A as one JSON object. */
#include <palpate/palpate.h>
#include <stdio.h>
#include <stdlib.h>

static void check(plp_result result) {
  if (result < 0) {
    fprintf(stderr, "%s: %s\n", plp_result_string(result), plp_last_error());
    exit(1);
  }
}

static void print_contacts(const plp_contacts* contacts) {
  const double* f = contacts->wrench.force;
  const double* t = contacts->wrench.torque;
  printf("{\"points\": %zu, \"sets\": %zu, ", contacts->lmd_count, contacts->set_count);
  printf("\"force\": [%.17g, %.17g, %.17g], \"torque\": [%.17g, %.17g, %.17g]}\n", f[0], f[1], f[2], t[0],
         t[1], t[2]);
}

int main(int argc, char** argv) {
  if (argc != 7) return 2;
  plp_model a, b;
  check(plp_model_load_file(argv[1], NULL, &a));
  check(plp_model_load_file(argv[2], NULL, &b));

  plp_pose a_from_b = {{atof(argv[3]), atof(argv[4]), atof(argv[5])}, {0, 0, 0, 1}};
  plp_query_options options;
  plp_query_options_init(&options, sizeof options);
  options.cutoff = atof(argv[6]);
  plp_query_result result;
  check(plp_query_result_create(&result));
  check(plp_query(a, b, &a_from_b, &options, result));

  plp_contacts contacts;
  plp_contacts_init(&contacts, sizeof contacts);
  check(plp_query_result_get(result, &contacts));
  print_contacts(&contacts);

  check(plp_query_result_release(result));
  check(plp_model_release(b));
  check(plp_model_release(a));
  return 0;
}
