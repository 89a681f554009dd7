// SPDX-License-Identifier: MIT
using UnityEditor;

namespace Palpate.Unity.Editor
{
    /// <summary>Ends native threads before the code that started them goes.</summary>
    [InitializeOnLoad]
    internal static class ReloadGuard
    {
        static ReloadGuard()
        {
            AssemblyReloadEvents.beforeAssemblyReload += Library.ShutDownAll;
            EditorApplication.quitting += Library.ShutDownAll;
        }
    }
}
