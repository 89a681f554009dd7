// As much of NUnit as the tests use, for runtimes that its own runner cannot run under.
using System;

namespace NUnit.Framework
{
    [AttributeUsage(AttributeTargets.Class)]
    public sealed class TestFixtureAttribute : Attribute
    {
    }

    [AttributeUsage(AttributeTargets.Method)]
    public sealed class TestAttribute : Attribute
    {
    }

    public sealed class AssertionException : Exception
    {
        public AssertionException(string message) : base(message)
        {
        }
    }

    public delegate void TestDelegate();

    public static class Assert
    {
        public static void IsTrue(bool condition, string message = "")
        {
            if (!condition)
            {
                throw new AssertionException("is not true: " + message);
            }
        }

        public static void AreEqual(object expected, object actual, string message = "")
        {
            if (!Equals(expected, actual))
            {
                throw new AssertionException("expected " + expected + ", got " + actual + ": " + message);
            }
        }

        public static void AreEqual(double expected, double actual, double tolerance, string message = "")
        {
            // Written so that a NaN is not equal.
            if (!(Math.Abs(expected - actual) <= tolerance))
            {
                throw new AssertionException("expected " + expected + ", got " + actual + ": " + message);
            }
        }

        public static T Throws<T>(TestDelegate code) where T : Exception
        {
            Exception thrown = null;
            try
            {
                code();
            }
            catch (Exception error)
            {
                thrown = error;
            }
            if (thrown == null || thrown.GetType() != typeof(T))
            {
                throw new AssertionException("expected " + typeof(T) + ", got " + (thrown == null ? "nothing" : thrown.ToString()));
            }
            return (T)thrown;
        }
    }
}
