using System.IO;
using System.Linq;
using System.Threading;

namespace Palpate.Unity.Tests
{
    /// <summary>The native threads of the library in this process.</summary>
    internal static class Threads
    {
        internal static int Count() => Directory.GetDirectories("/proc/self/task").Count(IsOurs);

        /// <summary>A thread that was joined may be listed for a moment, and one that begins is not named yet.</summary>
        internal static int Settled(int wanted)
        {
            for (int i = 0; i < 1000 && Count() != wanted; ++i)
            {
                Thread.Sleep(1);
            }
            return Count();
        }

        private static bool IsOurs(string task)
        {
            try
            {
                return File.ReadAllText(task + "/comm").StartsWith("palpate-");
            }
            catch (IOException)
            {
                return false;
            }
        }
    }
}
