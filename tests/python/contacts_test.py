"""How long contacts live."""

import gc
import unittest
import weakref

import palpate
from palpate import _raw
from palpate._errors import check
from palpate.contacts import new_contacts_struct
from shapes import beside, box


def distances(contacts):
    return [float(contact["distance"]) for contact in contacts.contacts]


class LifetimeTest(unittest.TestCase):
    def test_an_array_keeps_its_memory(self):
        first = palpate.query(box(), box(), beside(1.1), 0.2)
        before = distances(first)
        records = first.contacts
        del first
        for _ in range(50):
            palpate.query(box(), box(), beside(1.15), 0.2)
        gc.collect()
        self.assertEqual([float(record["distance"]) for record in records], before)

    def test_one_record_keeps_its_memory(self):
        record = palpate.query(box(), box(), beside(1.1), 0.2).contacts[0]
        gc.collect()
        self.assertAlmostEqual(record["distance"], 0.1, delta=1e-9)

    def test_the_memory_goes_with_the_last_view(self):
        result = palpate.QueryResult()
        contacts = palpate.query(box(), box(), beside(1.1), 0.2, result=result)
        handle, alive = result._handle, weakref.ref(result._native)
        records = contacts.contacts
        result.close()
        del contacts
        self.assertEqual(len(records), 4)
        check(_raw.plp_query_result_get(handle, new_contacts_struct()))
        del records
        self.assertIsNone(alive())
        with self.assertRaises(palpate.InvalidHandle):
            check(_raw.plp_query_result_get(handle, new_contacts_struct()))

    def test_every_query_has_memory_of_its_own(self):
        near = palpate.query(box(), box(), beside(1.05), 0.2)
        far = palpate.query(box(), box(), beside(1.15), 0.2)
        self.assertAlmostEqual(distances(near)[0], 0.05, delta=1e-9)
        self.assertAlmostEqual(distances(far)[0], 0.15, delta=1e-9)


class OverwrittenTest(unittest.TestCase):
    def setUp(self):
        self.result = palpate.QueryResult()
        self.first = self.search(1.1)

    def search(self, x, cutoff=0.2):
        return palpate.query(box(), box(), beside(x), cutoff, result=self.result)

    def test_arrays_of_an_overwritten_outcome_are_refused(self):
        second = self.search(1.05)
        self.assertAlmostEqual(distances(second)[0], 0.05, delta=1e-9)
        for read in (lambda: self.first.contacts, lambda: self.first.overlaps, lambda: self.first.springs,
                     self.first.copy):
            with self.assertRaisesRegex(palpate.InvalidHandle, "copy"):
                read()

    def test_its_numbers_stay(self):
        self.search(1.05)
        self.assertAlmostEqual(self.first.min_distance, 0.1, delta=1e-9)
        self.assertAlmostEqual(self.first.wrench.force[0], 100, delta=1e-6)

    def test_a_search_that_fails_overwrites_too(self):
        with self.assertRaises(palpate.InvalidArgument):
            self.search(1.05, cutoff=-1)
        with self.assertRaises(palpate.InvalidHandle):
            self.first.contacts

    def test_a_copy_stays(self):
        before = distances(self.first)
        copy = self.first.copy()
        self.search(1.05)
        self.result.close()
        self.assertEqual(distances(copy), before)
        self.assertEqual(distances(copy.copy()), before)
        self.assertEqual(copy.set_count, 1)
        self.assertEqual(copy.wrench, self.first.wrench)
        self.assertEqual(len(copy.overlaps), 0)
        self.assertEqual([tuple(spring["force"]) for spring in copy.springs],
                         [tuple(contact["force"]) for contact in copy.contacts])

    def test_a_copy_of_nothing(self):
        copy = self.search(9).copy()
        self.assertEqual((len(copy.contacts), len(copy.overlaps)), (0, 0))
