using System;
using NUnit.Framework;

namespace Palpate.Tests
{
    [TestFixture]
    public class QueryTest
    {
        [Test]
        public void TwoBoxesPushApart()
        {
            using (Model box = Samples.Box())
            using (var result = new QueryResult())
            {
                Contacts contacts = result.Search(box, box, new Pose(1.1, 0, 0), new QueryOptions { Cutoff = 0.2 });
                Assert.AreEqual(1, contacts.SetCount);
                Assert.AreEqual(4, contacts.Lmds.Count);
                Assert.AreEqual(0.1, contacts.MinDistance, 1e-12);
                Assert.AreEqual(100, contacts.Wrench.Force.X, 1e-9);
                Assert.IsTrue(!contacts.Overlap && contacts.SearchUs > 0 && contacts.Work.NodePairs > 0);
                double weights = 0;
                foreach (Contact contact in contacts.Lmds)
                {
                    Assert.AreEqual(1, contact.Normal.X, 1e-12);
                    weights += contact.Weight;
                }
                Assert.AreEqual(1, weights, 1e-12);
            }
        }

        [Test]
        public void OverlapsAreListed()
        {
            using (Model box = Samples.Box())
            using (var result = new QueryResult())
            {
                var options = new QueryOptions { Cutoff = 0.2, MaxOverlaps = 2 };
                Contacts contacts = result.Search(box, box, new Pose(0.9, 0.05, 0.03), options);
                Assert.IsTrue(contacts.Overlap && contacts.OverlapsCut);
                Assert.AreEqual(2, contacts.Overlaps.Count);
                Assert.IsTrue(contacts.Overlaps[0].TriangleA < 12);
            }
        }

        [Test]
        public void TorqueIsAboutTheReferencePoint()
        {
            using (Model box = Samples.Box())
            using (var result = new QueryResult())
            {
                var options = new QueryOptions { Cutoff = 0.2, ReferencePoint = new Vector3d(0, 1, 0) };
                Contacts contacts = result.Search(box, box, new Pose(1.1, 0, 0), options);
                Assert.AreEqual(100, contacts.Wrench.Torque.Z, 1e-9);
            }
        }

        [Test]
        public void ListsCanBeCopied()
        {
            using (Model box = Samples.Box())
            using (var result = new QueryResult())
            {
                Contacts contacts = result.Search(box, box, new Pose(1.1, 0, 0), new QueryOptions { Cutoff = 0.2 });
                Contact[] copy = contacts.Lmds.ToArray();
                Assert.AreEqual(4, copy.Length);
                ReadOnlySpan<Contact> span;
                Assert.IsTrue(contacts.Lmds.TryGetSpan(out span) && span.Length == 4);
                var two = new Contact[2];
                Assert.AreEqual(2, contacts.Lmds.CopyTo(two));
                for (int i = 0; i < 2; ++i)
                {
                    Assert.AreEqual(contacts.Lmds[i].PointB, copy[i].PointB);
                    Assert.AreEqual(span[i].PointB, two[i].PointB);
                }
                Assert.Throws<ArgumentOutOfRangeException>(() => contacts.Lmds[4].ToString());
                Assert.Throws<ArgumentOutOfRangeException>(() => contacts.Lmds[-1].ToString());
            }
        }

        [Test]
        public void EqualsTheResultOfCBitForBit()
        {
            using (var reference = new Reference())
            using (Model body = Model.Load(Samples.ModelPath("torus.glb")))
            using (Model tool = Model.Load(Samples.ModelPath("organic_2200.glb")))
            using (var result = new QueryResult())
            {
                int count = reference.Count(), lmds = 0;
                for (int i = 0; i < count; ++i)
                {
                    Contacts contacts = result.Search(body, tool, reference.Pose(), new QueryOptions { Cutoff = reference.Cutoff });
                    Assert.AreEqual(reference.Count(), contacts.Lmds.Count);
                    Assert.AreEqual(reference.Count(), contacts.SetCount);
                    Assert.IsTrue(Reference.Same(reference.Double(), contacts.MinDistance));
                    Assert.IsTrue(Reference.Same(reference.Wrench(), contacts.Wrench));
                    foreach (Contact contact in contacts.Lmds)
                    {
                        RequireSame(reference, contact);
                        ++lmds;
                    }
                }
                Assert.IsTrue(lmds > 10, lmds + " LMDs");
            }
        }

        private static void RequireSame(Reference reference, Contact contact)
        {
            Assert.IsTrue(Reference.Same(reference.Vector(), contact.PointA));
            Assert.IsTrue(Reference.Same(reference.Vector(), contact.PointB));
            Assert.IsTrue(Reference.Same(reference.Vector(), contact.Normal));
            Assert.IsTrue(Reference.Same(reference.Double(), contact.Distance));
            Assert.IsTrue(Reference.Same(reference.Double(), contact.Weight));
            Assert.IsTrue(Reference.Same(reference.Vector(), contact.Force));
        }
    }
}
