// Runs every test of this program. The last line is "N passed, N failed".
using System;
using System.Reflection;
using NUnit.Framework;

public static class Runner
{
    private static int passed;
    private static int failed;

    public static int Main()
    {
        foreach (Type type in typeof(Runner).Assembly.GetTypes())
        {
            if (type.IsDefined(typeof(TestFixtureAttribute), false))
            {
                RunFixture(type);
            }
        }
        Console.WriteLine(passed + " passed, " + failed + " failed");
        return passed > 0 && failed == 0 ? 0 : 1;
    }

    private static void RunFixture(Type type)
    {
        foreach (MethodInfo method in type.GetMethods())
        {
            if (method.IsDefined(typeof(TestAttribute), false))
            {
                RunTest(type, method);
            }
        }
    }

    private static void RunTest(Type type, MethodInfo method)
    {
        try
        {
            method.Invoke(Activator.CreateInstance(type), null);
            ++passed;
        }
        catch (TargetInvocationException error)
        {
            ++failed;
            Console.WriteLine("FAILED " + type.Name + "." + method.Name + ": " + error.InnerException);
        }
    }
}
