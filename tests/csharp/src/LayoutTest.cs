using System;
using System.Collections.Generic;
using System.IO;
using System.Reflection;
using System.Runtime.InteropServices;
using System.Text;
using NUnit.Framework;

namespace Palpate.Tests
{
    /// <summary>Against what the C compiler makes of palpate.h: a line for each size, offset and value.</summary>
    [TestFixture]
    public class LayoutTest
    {
        [Test]
        public void StructsHaveTheCompilersLayout()
        {
            var seen = new Dictionary<string, int>();
            foreach (string[] words in Lines("struct"))
            {
                Type type = RawType(words[1]);
                Assert.AreEqual(int.Parse(words[2]), Marshal.SizeOf(type), words[1]);
                seen.Add(words[1], 0);
            }
            foreach (string[] words in Lines("offset"))
            {
                int offset = (int)Marshal.OffsetOf(RawType(words[1]), words[2]);
                Assert.AreEqual(int.Parse(words[3]), offset, words[1] + "." + words[2]);
                ++seen[words[1]];
            }
            foreach (string[] words in Lines("size"))
            {
                Type field = RawType(words[1]).GetField(words[2]).FieldType;
                int size = field.IsPointer ? IntPtr.Size : Marshal.SizeOf(field);
                Assert.AreEqual(int.Parse(words[3]), size, words[1] + "." + words[2]);
            }
            Assert.IsTrue(seen.Count > 10);
            foreach (Type type in typeof(Raw).GetNestedTypes())
            {
                Assert.IsTrue(!type.IsValueType || seen[type.Name] == type.GetFields().Length, type.Name);
            }
        }

        [Test]
        public void ConstantsHaveTheCompilersValues()
        {
            int count = 0;
            foreach (string[] words in Lines("value"))
            {
                object value = typeof(Raw).GetField(words[1]).GetRawConstantValue();
                Assert.AreEqual(int.Parse(words[2]), (int)value, words[1]);
                ++count;
            }
            Assert.IsTrue(count > 30);
            // Library is no number.
            Assert.AreEqual(count + 1, typeof(Raw).GetFields().Length);
        }

        [Test]
        public void HandlesAndEnumsHaveTheSizeTheyArePassedWith()
        {
            int count = 0;
            foreach (string[] words in Lines("handle"))
            {
                Assert.AreEqual(IntPtr.Size, int.Parse(words[2]), words[1]);
                ++count;
            }
            foreach (string[] words in Lines("enum"))
            {
                Assert.AreEqual(sizeof(int), int.Parse(words[2]), words[1]);
                ++count;
            }
            Assert.IsTrue(count > 5);
        }

        [Test]
        public void EveryFunctionIsInTheLibrary()
        {
            int count = 0;
            foreach (MethodInfo method in typeof(Raw).GetMethods(BindingFlags.Public | BindingFlags.Static))
            {
                Marshal.Prelink(method);
                ++count;
            }
            Assert.IsTrue(count > 30);
        }

        [Test]
        public void StructsThatAreViewedHaveTheLayoutOfTheRawOnes()
        {
            RequireSame(typeof(Contact), typeof(Raw.plp_lmd));
            RequireSame(typeof(Overlap), typeof(Raw.plp_overlap));
            RequireSame(typeof(Work), typeof(Raw.plp_work));
            RequireSame(typeof(Pose), typeof(Raw.plp_pose));
            RequireSame(typeof(Wrench), typeof(Raw.plp_wrench));
            Assert.AreEqual(Marshal.SizeOf(typeof(Raw.plp_space)), Marshal.SizeOf(typeof(Space)));
            Assert.AreEqual(Marshal.OffsetOf(typeof(Raw.plp_space), "metres_per_unit"),
                            Marshal.OffsetOf(typeof(Space), "MetresPerUnit"));
        }

        private static void RequireSame(Type view, Type raw)
        {
            Assert.AreEqual(Marshal.SizeOf(raw), Marshal.SizeOf(view), raw.Name);
            Assert.AreEqual(raw.GetFields().Length, view.GetFields().Length, raw.Name);
            foreach (FieldInfo field in view.GetFields())
            {
                Assert.AreEqual(Marshal.OffsetOf(raw, SnakeCase(field.Name)), Marshal.OffsetOf(view, field.Name),
                                raw.Name + "." + field.Name);
            }
        }

        private static string SnakeCase(string name)
        {
            var text = new StringBuilder();
            foreach (char letter in name)
            {
                text.Append(char.IsUpper(letter) && text.Length > 0 ? "_" : "").Append(char.ToLowerInvariant(letter));
            }
            return text.ToString();
        }

        private static Type RawType(string name)
        {
            Type type = typeof(Raw).GetNestedType(name);
            Assert.IsTrue(type != null, name);
            return type;
        }

        private static IEnumerable<string[]> Lines(string kind)
        {
            foreach (string line in File.ReadAllLines(Samples.LayoutPath))
            {
                string[] words = line.Split(' ');
                if (words[0] == kind)
                {
                    yield return words;
                }
            }
        }
    }
}
