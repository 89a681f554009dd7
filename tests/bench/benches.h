#pragma once

#include "tests/bench/effort.h"
#include "tests/bench/table.h"

namespace palpate::bench {

// Nanoseconds a pair of the wide tests of triangles and nodes, for every instruction set of the processor.
void bench_kernels(const Effort& effort, Table& table);

// Time and memory of the hierarchy against the number of triangles of one shape.
void bench_build(const Effort& effort, Table& table);

// Every method on the named pairs of models: time, and error against the complete set of the same tick.
void bench_pairs(const Effort& effort, Table& table);

// Time of a tick against the number of triangles of one shape.
void bench_growth(const Effort& effort, Table& table);

// What distant bodies add to a tick.
void bench_bodies(const Effort& effort, Table& table);

}  // namespace palpate::bench
