// SPDX-License-Identifier: MIT
using Palpate;
using Palpate.Unity;
using UnityEngine;

/// <summary>Put it on an empty object: it makes a scene of two spheres, gives one to a simulated hand that presses, and
/// shows the force in the console.</summary>
public sealed class TouchSample : MonoBehaviour
{
    private PalpateScene scene;
    private HapticDevice device;
    private float shown;

    private void Start()
    {
        gameObject.SetActive(false);
        scene = gameObject.AddComponent<PalpateScene>();
        scene.cutoff = 0.01f;
        scene.stiffness = 300;

        GameObject still = GameObject.CreatePrimitive(PrimitiveType.Sphere);
        still.transform.SetParent(transform, false);
        still.transform.localScale = 0.1f * Vector3.one;
        still.transform.localPosition = 0.105f * Vector3.down;
        still.AddComponent<HapticBody>();

        GameObject moving = GameObject.CreatePrimitive(PrimitiveType.Sphere);
        moving.transform.SetParent(transform, false);
        moving.transform.localScale = 0.1f * Vector3.one;
        moving.AddComponent<HapticTool>();

        device = gameObject.AddComponent<HapticDevice>();
        device.hand = HandScript.Press;
        gameObject.SetActive(true);
        device.Arm();
    }

    private void Update()
    {
        if (scene != null && Time.time > shown + 1)
        {
            shown = Time.time;
            Debug.Log($"{scene.ContactCount} contacts, force {scene.Force} N");
        }
    }
}
