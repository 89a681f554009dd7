// As much of Unity's editor as the package uses.
using System;
using System.Collections.Generic;
using UnityEngine;

namespace UnityEditor
{
    [AttributeUsage(AttributeTargets.Class)]
    public sealed class InitializeOnLoadAttribute : Attribute
    {
    }

    [AttributeUsage(AttributeTargets.Class)]
    public sealed class CustomEditorAttribute : Attribute
    {
        public readonly Type Inspected;

        public CustomEditorAttribute(Type inspected)
        {
            Inspected = inspected;
        }
    }

    public class Editor
    {
        public UnityEngine.Object target;
        public virtual void OnInspectorGUI()
        {
        }

        public virtual bool RequiresConstantRepaint() => false;
        public bool DrawDefaultInspector() => false;
    }

    public static class AssemblyReloadEvents
    {
        public static event Action beforeAssemblyReload;
        public static void Reload() => beforeAssemblyReload?.Invoke();
    }

    public static class EditorApplication
    {
        public static event Action quitting;
        public static void Quit() => quitting?.Invoke();
    }

    public static class EditorGUI
    {
        public static void DrawRect(Rect area, Color colour)
        {
        }
    }

    public static class EditorGUILayout
    {
        public static readonly List<string> Labels = new List<string>();
        public static void LabelField(string text) => Labels.Add(text);
        public static void LabelField(string name, string text) => Labels.Add(name + ": " + text);
    }

    public static class Handles
    {
        public static Color color;
        public static Vector3[] Line;
        public static void DrawPolyLine(Vector3[] points) => Line = points;
    }
}
