using System;
using System.Collections.Generic;
using System.Threading;
using NUnit.Framework;

namespace Palpate.Tests
{
    [TestFixture]
    public class LogTest
    {
        [Test]
        public void MessagesArriveOnTheCallingThread()
        {
            var messages = new List<string>();
            var threads = new List<Thread>();
            Log.SetReceiver((level, message) =>
            {
                messages.Add(message);
                threads.Add(Thread.CurrentThread);
            });
            try
            {
                LoadBadly();
            }
            finally
            {
                Log.SetReceiver(null);
            }
            Assert.IsTrue(messages.Count > 0 && messages[0].Length > 0);
            Assert.IsTrue(threads.TrueForAll(thread => thread == Thread.CurrentThread));
            int count = messages.Count;
            LoadBadly();
            Assert.AreEqual(count, messages.Count);
        }

        [Test]
        public void WhatAReceiverThrowsIsDropped()
        {
            Log.SetReceiver((level, message) => throw new InvalidOperationException("on purpose"));
            try
            {
                LoadBadly();
            }
            finally
            {
                Log.SetReceiver(null);
            }
        }

        /// <summary>An inside-out box, about which there is something to say.</summary>
        private static void LoadBadly()
        {
            int[] inward = (int[])Samples.BoxIndices.Clone();
            Array.Reverse(inward);
            using (Model.FromTriangles(Samples.BoxPositions, inward))
            {
            }
        }
    }
}
