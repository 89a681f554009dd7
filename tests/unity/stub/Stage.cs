// What Unity's player does: play sessions, frames, and the messages that components get.
using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;

namespace UnityEngine
{
    public static class Stage
    {
        public static readonly List<GameObject> Objects = new List<GameObject>();
        private const BindingFlags Any = BindingFlags.Instance | BindingFlags.Static | BindingFlags.Public |
            BindingFlags.NonPublic;

        public static readonly Mesh Octahedron = new Mesh
        {
            vertices = new[]
            {
                new Vector3(0.5f, 0, 0), new Vector3(-0.5f, 0, 0), new Vector3(0, 0.5f, 0), new Vector3(0, -0.5f, 0),
                new Vector3(0, 0, 0.5f), new Vector3(0, 0, -0.5f)
            },
            // Clockwise seen from outside in Unity's left-handed world.
            triangles = new[] { 4, 0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 5, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3 }
        };

        /// <summary>Without a domain reload: static fields of the package are as the last session left them.</summary>
        public static void Begin(Assembly package)
        {
            foreach (Type type in package.GetTypes())
            {
                foreach (MethodInfo method in type.GetMethods(Any))
                {
                    if (method.GetCustomAttribute<RuntimeInitializeOnLoadMethodAttribute>() != null)
                    {
                        method.Invoke(null, null);
                    }
                }
            }
            Application.isPlaying = true;
            Settle();
        }

        public static void End()
        {
            Application.isPlaying = false;
            Settle();
            Objects.Clear();
        }

        /// <summary>Enables and disables what should be, in the order that the components ask for.</summary>
        public static void Settle()
        {
            foreach (Behaviour behaviour in Behaviours())
            {
                bool active = Application.isPlaying && behaviour.enabled && Active(behaviour.transform);
                if (active != behaviour.Running)
                {
                    behaviour.Running = active;
                    Send(behaviour, active ? "OnEnable" : "OnDisable");
                }
            }
        }

        public static void Frame()
        {
            Time.time += Time.fixedDeltaTime;
            foreach (Behaviour behaviour in Running())
            {
                if (!behaviour.Started)
                {
                    behaviour.Started = true;
                    Send(behaviour, "Start");
                }
            }
            foreach (string message in new[] { "FixedUpdate", "Update", "OnDrawGizmos" })
            {
                foreach (Behaviour behaviour in Running())
                {
                    Send(behaviour, message);
                }
            }
        }

        /// <summary>A value was changed in the inspector.</summary>
        public static void Validate(Behaviour behaviour) => Send(behaviour, "OnValidate");

        private static Behaviour[] Running() => Behaviours().Where(behaviour => behaviour.Running).ToArray();

        private static Behaviour[] Behaviours() => Objects.SelectMany(one => one.Components).OfType<Behaviour>()
            .OrderBy(behaviour => Order(behaviour.GetType())).ToArray();

        private static int Order(Type type) => type.GetCustomAttribute<DefaultExecutionOrderAttribute>()?.Order ?? 0;

        private static bool Active(Transform transform) =>
            transform == null || (transform.gameObject.activeSelf && Active(transform.parent));

        private static void Send(Behaviour behaviour, string message)
        {
            for (Type type = behaviour.GetType(); type != typeof(MonoBehaviour); type = type.BaseType)
            {
                MethodInfo method = type.GetMethod(message, Any | BindingFlags.DeclaredOnly);
                if (method != null)
                {
                    method.Invoke(behaviour, null);
                    return;
                }
            }
        }
    }
}
