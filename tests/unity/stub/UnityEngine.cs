// As much of Unity as the package uses, for compiling and running it without Unity: objects, their messages in Unity's
// order, and numbers. What draws counts what it was asked to draw.
using System;
using System.Collections.Generic;

namespace UnityEngine
{
    public struct Vector3 : IEquatable<Vector3>
    {
        public float x;
        public float y;
        public float z;

        public Vector3(float x, float y, float z)
        {
            this.x = x;
            this.y = y;
            this.z = z;
        }

        public static Vector3 zero => new Vector3(0, 0, 0);
        public static Vector3 one => new Vector3(1, 1, 1);
        public static Vector3 down => new Vector3(0, -1, 0);
        public float magnitude => (float)Math.Sqrt(x * x + y * y + z * z);
        public static Vector3 operator *(float scale, Vector3 v) => new Vector3(scale * v.x, scale * v.y, scale * v.z);
        public static Vector3 operator /(Vector3 v, float scale) => new Vector3(v.x / scale, v.y / scale, v.z / scale);
        public bool Equals(Vector3 other) => x == other.x && y == other.y && z == other.z;
        public override bool Equals(object other) => other is Vector3 && Equals((Vector3)other);
        public override int GetHashCode() => x.GetHashCode() ^ y.GetHashCode() << 2 ^ z.GetHashCode() >> 2;
        public override string ToString() => $"({x}, {y}, {z})";
    }

    public struct Quaternion
    {
        public float x;
        public float y;
        public float z;
        public float w;

        public Quaternion(float x, float y, float z, float w)
        {
            this.x = x;
            this.y = y;
            this.z = z;
            this.w = w;
        }

        public static Quaternion identity => new Quaternion(0, 0, 0, 1);
    }

    public struct Rect
    {
        public float x;
        public float y;
        public float width;
        public float height;
    }

    public struct Color
    {
        public float r;
        public float g;
        public float b;
        public float a;

        public Color(float r, float g, float b, float a = 1)
        {
            this.r = r;
            this.g = g;
            this.b = b;
            this.a = a;
        }

        public static Color red => new Color(1, 0, 0);
        public static Color yellow => new Color(1, 0.92f, 0.016f);
        public static Color cyan => new Color(0, 1, 1);
        public static Color Lerp(Color from, Color to, float t) => t < 0.5f ? from : to;
    }

    public static class Mathf
    {
        public static float Max(float a, float b) => Math.Max(a, b);
    }

    public static class Time
    {
        public static float time;
        public static float fixedDeltaTime = 0.02f;
    }

    public static class Application
    {
        public static bool isPlaying;
        public static string streamingAssetsPath = "";
    }

    public static class Debug
    {
        public static readonly List<string> Errors = new List<string>();
        public static readonly List<string> Messages = new List<string>();
        public static void Log(object message) => Messages.Add(message.ToString());
        public static void LogError(object message, Object context) => Errors.Add(message.ToString());
    }

    public static class Gizmos
    {
        public static int Drawn;
        public static Color color;
        public static void DrawLine(Vector3 from, Vector3 to) => ++Drawn;
        public static void DrawSphere(Vector3 centre, float radius) => ++Drawn;
        public static void DrawRay(Vector3 from, Vector3 direction) => ++Drawn;
    }

    public class Object
    {
        public string name = "";
        public int GetInstanceID() => System.Runtime.CompilerServices.RuntimeHelpers.GetHashCode(this);
    }

    public class ScriptableObject : Object
    {
    }

    public sealed class Mesh : Object
    {
        public Vector3[] vertices = new Vector3[0];
        public int[] triangles = new int[0];
        public bool isReadable = true;
    }

    public class Component : Object
    {
        public GameObject gameObject { get; internal set; }
        public Transform transform => gameObject.transform;
        public T GetComponent<T>() where T : class => gameObject.GetComponent<T>();

        public T GetComponentInParent<T>() where T : class
        {
            for (Transform at = transform; at != null; at = at.parent)
            {
                T found = at.gameObject.activeSelf ? at.gameObject.GetComponent<T>() : null;
                if (found != null)
                {
                    return found;
                }
            }
            return null;
        }
    }

    public class Behaviour : Component
    {
        private bool wanted = true;
        internal bool Running;
        internal bool Started;

        public bool enabled
        {
            get => wanted;
            set
            {
                wanted = value;
                Stage.Settle();
            }
        }
    }

    public class MonoBehaviour : Behaviour
    {
    }

    public sealed class MeshFilter : Component
    {
        public Mesh sharedMesh;
    }

    /// <summary>Only the root may be turned: as much as the tests do.</summary>
    public sealed class Transform : Component
    {
        private Vector3 place;
        private Quaternion turn = Quaternion.identity;

        public Transform parent { get; private set; }
        public Vector3 localScale = Vector3.one;
        public bool hasChanged = true;

        public Vector3 position
        {
            get => place;
            set
            {
                place = value;
                hasChanged = true;
            }
        }

        public Vector3 localPosition
        {
            set => position = parent == null ? value
                : new Vector3(parent.place.x + value.x, parent.place.y + value.y, parent.place.z + value.z);
        }

        public Quaternion rotation
        {
            get => turn;
            set
            {
                turn = value;
                hasChanged = true;
            }
        }

        public Vector3 lossyScale => parent == null ? localScale : new Vector3(
            parent.lossyScale.x * localScale.x, parent.lossyScale.y * localScale.y, parent.lossyScale.z * localScale.z);

        public void SetParent(Transform above, bool worldPositionStays) => parent = above;

        public void SetPositionAndRotation(Vector3 position, Quaternion rotation)
        {
            this.position = position;
            this.rotation = rotation;
        }
    }

    public enum PrimitiveType
    {
        Sphere
    }

    public sealed class GameObject : Object
    {
        internal readonly List<Component> Components = new List<Component>();
        private readonly Transform place = new Transform();

        public GameObject()
        {
            place.gameObject = this;
            Stage.Objects.Add(this);
        }

        public Transform transform => place;
        public bool activeSelf { get; private set; } = true;

        public T AddComponent<T>() where T : Component, new()
        {
            var added = new T { gameObject = this, name = name };
            Components.Add(added);
            Stage.Settle();
            return added;
        }

        public T GetComponent<T>() where T : class
        {
            foreach (Component component in Components)
            {
                if (component is T)
                {
                    return component as T;
                }
            }
            return null;
        }

        public void SetActive(bool active)
        {
            activeSelf = active;
            Stage.Settle();
        }

        /// <summary>With the mesh of an octahedron as wide as Unity's sphere.</summary>
        public static GameObject CreatePrimitive(PrimitiveType type)
        {
            var made = new GameObject { name = type.ToString() };
            made.AddComponent<MeshFilter>().sharedMesh = Stage.Octahedron;
            return made;
        }
    }

    [AttributeUsage(AttributeTargets.Field)]
    public sealed class TooltipAttribute : Attribute
    {
        public TooltipAttribute(string text)
        {
        }
    }

    [AttributeUsage(AttributeTargets.Field)]
    public sealed class HeaderAttribute : Attribute
    {
        public HeaderAttribute(string text)
        {
        }
    }

    [AttributeUsage(AttributeTargets.Field)]
    public sealed class MinAttribute : Attribute
    {
        public MinAttribute(float least)
        {
        }
    }

    [AttributeUsage(AttributeTargets.Field)]
    public sealed class RangeAttribute : Attribute
    {
        public RangeAttribute(float least, float most)
        {
        }
    }

    [AttributeUsage(AttributeTargets.Class)]
    public sealed class AddComponentMenuAttribute : Attribute
    {
        public AddComponentMenuAttribute(string path)
        {
        }
    }

    [AttributeUsage(AttributeTargets.Class)]
    public sealed class DisallowMultipleComponentAttribute : Attribute
    {
    }

    [AttributeUsage(AttributeTargets.Class)]
    public sealed class DefaultExecutionOrderAttribute : Attribute
    {
        public readonly int Order;

        public DefaultExecutionOrderAttribute(int order)
        {
            Order = order;
        }
    }

    [AttributeUsage(AttributeTargets.Class)]
    public sealed class CreateAssetMenuAttribute : Attribute
    {
        public string menuName;
    }

    public enum RuntimeInitializeLoadType
    {
        SubsystemRegistration
    }

    [AttributeUsage(AttributeTargets.Method)]
    public sealed class RuntimeInitializeOnLoadMethodAttribute : Attribute
    {
        public RuntimeInitializeOnLoadMethodAttribute(RuntimeInitializeLoadType type)
        {
        }
    }

    public sealed class GUILayoutOption
    {
    }

    public static class GUILayout
    {
        public static bool Press;
        public static bool Button(string text) => Press;
        public static GUILayoutOption ExpandWidth(bool expand) => new GUILayoutOption();
    }

    public static class GUILayoutUtility
    {
        public static Rect GetRect(float width, float height, params GUILayoutOption[] options) =>
            new Rect { width = 300, height = height };
    }
}
